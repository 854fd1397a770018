/* Set-ups and scenes fail in many threads at once; every message is compared with the one of a single thread. The threads are
 * made by pthreads, which the thread sanitizer understands (it does not know libgomp). */
#include "kyvadlo.h"
#include <pthread.h>
#include <stdio.h>
#include <string.h>

enum { threads = 16, kinds = 12, rounds = 200, room = 512 };

/* In messages.f90: what a failure says, and numbers as text. */
void fortran_message(int which, char *text, int capacity);

static char expected[kinds][room];
static int wrong[threads];

static void one_message(int which, char *text)
{
   kyvadlo_orbit orbit;
   memset(text, 0, room);
   switch (which) {
   case 0:
      kyvadlo_orbit_from_heights(1.0, 9.80665, 1e-300, 1.5, &orbit, text, room);
      break;
   case 1:
      kyvadlo_orbit_from_energy(2.0, 1e300, -1e305, 0.125, &orbit, text, room);
      break;
   case 2:
      kyvadlo_orbit_from_heights(-0.3333333333333333, 9.80665, 0.0, 0.0, &orbit, text, room);
      break;
   case 3:
      strncpy(text, kyvadlo_message(KYVADLO_DOMAIN), room - 1);
      break;
   default:
      fortran_message(which - 4, text, room);
   }
}

static void *run(void *data)
{
   int me = (int)((char *)data - (char *)0), i, which;
   char text[room];
   for (i = 0; i < rounds; i++) {
      which = (i*7 + me) % kinds;
      one_message(which, text);
      if (memcmp(text, expected[which], room) != 0) {
         if (wrong[me]++ == 0) printf("thread %d: '%s' where one thread has '%s'\n", me, text, expected[which]);
      }
   }
   return NULL;
}

int main(void)
{
   pthread_t thread[threads];
   int i, failures = 0;
   for (i = 0; i < kinds; i++) {
      one_message(i, expected[i]);
      if (strlen(expected[i]) < 5) {
         printf("message %d is '%s'\n", i, expected[i]);
         failures++;
      }
   }
   for (i = 0; i < threads; i++) pthread_create(&thread[i], NULL, run, (char *)0 + i);
   for (i = 0; i < threads; i++) {
      pthread_join(thread[i], NULL);
      failures += wrong[i];
   }
   printf("%d messages of %d wrong\n", failures, threads*rounds);
   return failures > 0;
}
