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

/* Files being written: removed when the program is interrupted. An entry without a name is free. */
struct unfinished_file {
   int descriptor;
   char name[PATH_MAX];
   char final_name[PATH_MAX];
};
enum { most_files = 8 };
static struct unfinished_file files[most_files];

static struct unfinished_file *file_of(int descriptor)
{
   int i;
   for (i = 0; i < most_files; i++)
      if (files[i].name[0] != '\0' && files[i].descriptor == descriptor) return &files[i];
   return NULL;
}

static void remove_unfinished(int signal_number)
{
   int i;
   for (i = 0; i < most_files; i++)
      if (files[i].name[0] != '\0') unlink(files[i].name);
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
   struct unfinished_file *file = NULL;
   char name[PATH_MAX];
   mode_t mode = 0666;
   int exists = stat(path, &old) == 0, length, i;

   if (exists && S_ISDIR(old.st_mode)) return EISDIR;
   if (exists && access(path, W_OK) != 0) return errno;
   if (exists && !S_ISREG(old.st_mode)) {
      *descriptor = open(path, O_WRONLY);
      return *descriptor < 0 ? errno : 0;
   }
   for (i = most_files - 1; i >= 0; i--)
      if (files[i].name[0] == '\0') file = &files[i];
   if (file == NULL) return EMFILE;
   if (exists) {
      mode = old.st_mode & 0777;
      if (realpath(path, file->final_name) == NULL) return errno;
   } else {
      if (strlen(path) >= sizeof file->final_name) return ENAMETOOLONG;
      strcpy(file->final_name, path);
   }
   length = snprintf(name, sizeof name, "%s.part%ld", file->final_name, (long)getpid());
   if (length >= (int)sizeof name) return ENAMETOOLONG;
   *descriptor = open(name, O_WRONLY | O_CREAT | O_EXCL, mode);
   if (*descriptor < 0) return errno;
   file->descriptor = *descriptor;
   strcpy(file->name, name);
   return 0;
}

/* The name under which a file is written until it is whole, for libraries that open files by name; empty for a device or
   pipe. `text` has room for `size` bytes with the NUL. */
void kyvadlo_unfinished_name(int descriptor, char *text, int size)
{
   struct unfinished_file *file = file_of(descriptor);
   snprintf(text, (size_t)size, "%s", file == NULL ? "" : file->name);
}

/* Closes the file and gives it its name; 0 or errno, and then no file is left. */
int kyvadlo_finish_file(int descriptor)
{
   struct unfinished_file *file = file_of(descriptor);
   int status = 0;
   if (close(descriptor) != 0) status = errno;
   if (file != NULL) {
      if (status == 0 && rename(file->name, file->final_name) != 0) status = errno;
      if (status != 0) unlink(file->name);
      file->name[0] = '\0';
   }
   return status;
}

/* Closes the file and leaves nothing behind. */
void kyvadlo_discard_file(int descriptor)
{
   struct unfinished_file *file = file_of(descriptor);
   close(descriptor);
   if (file != NULL) {
      unlink(file->name);
      file->name[0] = '\0';
   }
}

/* Makes a folder, or finds it there and writable; 0 or errno. */
int kyvadlo_make_folder(const char *path)
{
   struct stat old;

   if (mkdir(path, 0777) == 0) return 0;
   if (errno != EEXIST) return errno;
   if (stat(path, &old) != 0) return errno;
   if (!S_ISDIR(old.st_mode)) return ENOTDIR;
   return access(path, W_OK | X_OK) == 0 ? 0 : errno;
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
