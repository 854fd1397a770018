/* The seal of a kyvadlo_orbit: its last word, a checksum of the others. Every function that reads an orbit looks at
   it first, so it is made of few additions: of 32 sums of every 32nd word, mixed by turns of their bits and odd
   factors. One wrong word always changes it, several by all likelihood. */
#include "kyvadlo.h"
#include <stdint.h>
#include <string.h>

#if defined(__GNUC__)
#define HIDDEN __attribute__((visibility("hidden")))
#else
#define HIDDEN
#endif

/* A multiple of 32. */
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
typedef uint64_t eight_words __attribute__((vector_size(64), aligned(8), may_alias));

static inline __attribute__((always_inline)) void add_up(const void *orbit, uint64_t sums[8])
{
   const eight_words *w = orbit, *end = w + WORDS / 8;
   eight_words a = w[0], b = w[1], c = w[2], d = w[3];

   while ((w += 4) < end) {
      a += w[0];
      b += w[1];
      c += w[2];
      d += w[3];
   }
   *(eight_words *)sums = a + (b << 11 | b >> 53) + (c << 23 | c >> 41) + (d << 37 | d >> 27);
}

#if defined(__x86_64__)
#define HAS_WIDE
__attribute__((target("avx2"))) static void add_up_avx2(const void *orbit, uint64_t sums[8])
{
   add_up(orbit, sums);
}

__attribute__((target("avx512f"))) static void add_up_avx512(const void *orbit, uint64_t sums[8])
{
   add_up(orbit, sums);
}
#endif
#else
static void add_up(const void *orbit, uint64_t sums[8])
{
   static const int turns[4] = {0, 11, 23, 37};
   uint64_t s[32] = {0}, w;
   int i;

   for (i = 0; i < WORDS; i++) {
      memcpy(&w, (const char *)orbit + 8 * i, sizeof w);
      s[i % 32] += w;
   }
   memcpy(sums, s, 8 * sizeof *sums);
   for (i = 8; i < 32; i++) sums[i % 8] += s[i] << turns[i / 8] | s[i] >> (64 - turns[i / 8]);
}
#endif

static uint64_t checksum(const kyvadlo_orbit *orbit)
{
   uint64_t sums[8];

#if defined(HAS_WIDE)
   if (__builtin_cpu_supports("avx512f"))
      add_up_avx512(orbit, sums);
   else if (__builtin_cpu_supports("avx2"))
      add_up_avx2(orbit, sums);
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
