/* What the program needs from POSIX and Fortran does not offer: output whose every failure is seen, files that are
   written beside their name and renamed when whole, and a quiet end on a closed pipe. */
#define _POSIX_C_SOURCE 200809L
#define _XOPEN_SOURCE 700
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* The unfinished file, for the signal handler: removed when the program is interrupted. */
static char unfinished[PATH_MAX];
static char final_name[PATH_MAX];

static void remove_unfinished(int signal_number)
{
   if (unfinished[0] != '\0') unlink(unfinished);
   signal(signal_number, SIG_DFL);
   raise(signal_number);
}

/* A closed pipe ends the program quietly, as it ends other filters. */
void kyvadlo_set_signals(void)
{
   signal(SIGPIPE, SIG_DFL);
   signal(SIGINT, remove_unfinished);
   signal(SIGTERM, remove_unfinished);
   signal(SIGHUP, remove_unfinished);
}

/* Reads at most `size` bytes from standard input; 0 at the end, negative errno on failure. */
long kyvadlo_read_input(char *buffer, long size)
{
   ssize_t count;
   do count = read(STDIN_FILENO, buffer, (size_t)size);
   while (count < 0 && errno == EINTR);
   return count < 0 ? -errno : (long)count;
}

/* Writes all bytes; 0 or errno. */
int kyvadlo_write(int descriptor, const char *bytes, long size)
{
   while (size > 0) {
      ssize_t count = write(descriptor, bytes, (size_t)size);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) return errno;
      bytes += count;
      size -= count;
   }
   return 0;
}

/* Opens `path` for writing. An ordinary file is written under another name in the same folder until
   kyvadlo_finish_file; a device or pipe is opened itself. Returns 0 or errno. */
int kyvadlo_open_file(const char *path, int *descriptor)
{
   struct stat old;
   mode_t mode = 0666;
   int exists = stat(path, &old) == 0;

   unfinished[0] = '\0';
   if (exists && S_ISDIR(old.st_mode)) return EISDIR;
   if (exists && access(path, W_OK) != 0) return errno;
   if (exists && !S_ISREG(old.st_mode)) {
      *descriptor = open(path, O_WRONLY);
      return *descriptor < 0 ? errno : 0;
   }
   if (exists) {
      mode = old.st_mode & 0777;
      if (realpath(path, final_name) == NULL) return errno;
   } else {
      if (strlen(path) >= sizeof final_name) return ENAMETOOLONG;
      strcpy(final_name, path);
   }
   {
      char name[PATH_MAX];
      int length = snprintf(name, sizeof name, "%s.part%ld", final_name, (long)getpid());
      if (length >= (int)sizeof name) return ENAMETOOLONG;
      *descriptor = open(name, O_WRONLY | O_CREAT | O_EXCL, mode);
      if (*descriptor < 0) return errno;
      strcpy(unfinished, name);
   }
   return 0;
}

/* Closes the file and gives it its name; 0 or errno, and then no file is left. */
int kyvadlo_finish_file(int descriptor)
{
   int status = 0;
   if (close(descriptor) != 0) status = errno;
   if (unfinished[0] != '\0') {
      if (status == 0 && rename(unfinished, final_name) != 0) status = errno;
      if (status != 0) unlink(unfinished);
      unfinished[0] = '\0';
   }
   return status;
}

/* Closes the file and leaves nothing behind. */
void kyvadlo_discard_file(int descriptor)
{
   close(descriptor);
   if (unfinished[0] != '\0') unlink(unfinished);
   unfinished[0] = '\0';
}

/* The system's words for an errno, as a string of at most `size` bytes with its NUL. */
void kyvadlo_describe(int number, char *text, int size)
{
   snprintf(text, (size_t)size, "%s", strerror(number));
}

int kyvadlo_is_terminal(int descriptor)
{
   return isatty(descriptor);
}
