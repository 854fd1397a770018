/* The seal of a kyvadlo_orbit: its last word, a checksum of the others. Every function that reads an orbit looks at it first, so
   it is made of few additions: each of eight lanes has the sums s of its words and t of the sums so far; all are mixed by odd
   factors. One wrong word always changes it, several by all likelihood. */
#include "kyvadlo.h"
#include <stdint.h>
#include <string.h>

#if defined(__GNUC__)
#define HIDDEN __attribute__((visibility("hidden")))
#else
#define HIDDEN
#endif

/* A multiple of 8. */
#define WORDS (KYVADLO_ORBIT_SIZE - 1)

/* Not 0, so that a zeroed struct has no seal. */
static const uint64_t beginning = 0x6b797661646c6f32u;

static uint64_t mixed(const uint64_t sums[8])
{
   static const uint64_t odd[8] = {0x9e3779b97f4a7c15u, 0xc2b2ae3d27d4eb4fu, 0x165667b19e3779f9u, 0xd6e8feb86659fd93u,
                                   0xff51afd7ed558ccdu, 0xc4ceb9fe1a85ec53u, 0xbf58476d1ce4e5b9u, 0x94d049bb133111ebu};
   uint64_t all = beginning;
   int lane;

   for (lane = 0; lane < 8; lane++) all += sums[lane] * odd[lane];
   return all;
}

#if defined(__GNUC__)
typedef uint64_t four_words __attribute__((vector_size(32)));

static inline __attribute__((always_inline)) void add_up(const void *orbit, uint64_t sums[8])
{
   four_words w, s = {0, 0, 0, 0}, t = s, s_next = s, t_next = s;
   int i;

   for (i = 0; i < WORDS; i += 8) {
      memcpy(&w, (const char *)orbit + 8 * i, sizeof w);
      s += w;
      t += s;
      memcpy(&w, (const char *)orbit + 8 * i + 32, sizeof w);
      s_next += w;
      t_next += s_next;
   }
   s += s_next << 7 | s_next >> 57;
   t += t_next << 13 | t_next >> 51;
   memcpy(sums, &s, sizeof s);
   memcpy(sums + 4, &t, sizeof t);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) static void add_up_wide(const void *orbit, uint64_t sums[8])
{
   add_up(orbit, sums);
}
#endif
#else
static void add_up(const void *orbit, uint64_t sums[8])
{
   uint64_t w[8], s[8] = {0}, t[8] = {0};
   int i, lane;

   for (i = 0; i < WORDS; i += 8) {
      memcpy(w, (const char *)orbit + 8 * i, sizeof w);
      for (lane = 0; lane < 8; lane++) t[lane] += s[lane] += w[lane];
   }
   for (lane = 0; lane < 4; lane++) {
      sums[lane] = s[lane] + (s[lane + 4] << 7 | s[lane + 4] >> 57);
      sums[4 + lane] = t[lane] + (t[lane + 4] << 13 | t[lane + 4] >> 51);
   }
}
#endif

static uint64_t checksum(const kyvadlo_orbit *orbit)
{
   uint64_t sums[8];

#if defined(__GNUC__) && defined(__x86_64__)
   if (__builtin_cpu_supports("avx2"))
      add_up_wide(orbit, sums);
   else
#endif
      add_up(orbit, sums);
   return mixed(sums);
}

HIDDEN void kyvadlo_put_seal(kyvadlo_orbit *orbit)
{
   uint64_t seal = checksum(orbit);

   memcpy(&orbit->hidden[WORDS], &seal, sizeof seal);
}

HIDDEN int kyvadlo_has_seal(const kyvadlo_orbit *orbit)
{
   uint64_t seal;

   memcpy(&seal, &orbit->hidden[WORDS], sizeof seal);
   return seal == checksum(orbit);
}
