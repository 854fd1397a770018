/* The bytes of a file or of standard input, which is descriptor 0 and no file opened again: whoever read before us has
   read, and a socket can be read too. Failures are negative errnos. */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#define O_BINARY 0
#endif

#if defined(__GNUC__)
#pragma GCC visibility push(hidden)   /* not for who links a shared kyvadlo */
#endif

int kyvadlo_open_input(const char *path)
{
   int descriptor;
   do descriptor = open(path, O_RDONLY | O_BINARY);
   while (descriptor < 0 && errno == EINTR);
   return descriptor < 0 ? -errno : descriptor;
}

/* Reads at most `size` bytes; 0 at the end. */
long kyvadlo_read_input(int descriptor, char *buffer, long size)
{
   long count;
   do count = (long)read(descriptor, buffer, (size_t)size);
   while (count < 0 && errno == EINTR);
   return count < 0 ? -errno : count;
}

void kyvadlo_close_input(int descriptor)
{
   close(descriptor);
}

/* The system's words for an errno, as a string of at most `size` bytes with its NUL. */
void kyvadlo_describe(int number, char *text, int size)
{
   snprintf(text, (size_t)size, "%s", strerror(number));
}
