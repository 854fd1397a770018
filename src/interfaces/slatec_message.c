/* SLATEC's error handler, called where the program has one. The reference is weak: a program without XERMSG links and
   hears nothing. Only ELF has that; elsewhere nothing is called. */
#include <stddef.h>

#ifdef __ELF__
void xermsg_(const char *library, const char *routine, const char *message, const int *code, const int *level,
             size_t library_length, size_t routine_length, size_t message_length) __attribute__((weak));

/* For the Fortran beside it in the library, not for others. */
void kyvadlo_call_xermsg(const char *, size_t, const char *, size_t, int) __attribute__((visibility("hidden")));
#endif

void kyvadlo_call_xermsg(const char *routine, size_t routine_length, const char *message, size_t message_length,
                         int code)
{
#ifdef __ELF__
   const int recoverable = 1;

   if (xermsg_ != NULL)
      xermsg_("SLATEC", routine, message, &code, &recoverable, 6, routine_length, message_length);
#else
   (void)routine; (void)routine_length; (void)message; (void)message_length; (void)code;
#endif
}
