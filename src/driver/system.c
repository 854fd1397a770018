/* What the program needs from the system and Fortran does not offer: output whose every failure is seen, files that are
   written under a random name and renamed when whole, signals that leave nothing behind, gnuplot without a shell.
   system_posix.inc and system_windows.inc offer the same functions. Where nothing else is said they return 0 or an
   errno. */
#define _XOPEN_SOURCE 700
#define _DEFAULT_SOURCE
#define _DARWIN_C_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#ifdef _WIN32
#include <direct.h>
#include <io.h>
#include <process.h>
#include <windows.h>
#define PATH_SIZE 4096
#else
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif
#define PATH_SIZE PATH_MAX
#define O_BINARY 0
#endif

/* Files being written: removed when the program ends early. An entry without a name is free. */
struct unfinished_file {
   int descriptor;
   int old_descriptor;          /* Of the old file, where the whole content is copied into it; else -1 */
   char name[PATH_SIZE];
   char final_name[PATH_SIZE];
};
enum { most_files = 32 };
static struct unfinished_file files[most_files];

static struct unfinished_file *file_of(int descriptor)
{
   int i;
   for (i = 0; i < most_files; i++)
      if (files[i].name[0] != '\0' && files[i].descriptor == descriptor) return &files[i];
   return NULL;
}

static struct unfinished_file *free_file(void)
{
   int i;
   for (i = 0; i < most_files; i++)
      if (files[i].name[0] == '\0') return &files[i];
   return NULL;
}

/* Removes every unfinished file; may be called from a handler of signals. */
void kyvadlo_remove_unfinished(void)
{
   int i;
   for (i = 0; i < most_files; i++)
      if (files[i].name[0] != '\0') unlink(files[i].name);
}

/* Eight random bytes; where the system gives none, what no two runs have in common. */
static unsigned long long random_number(void)
{
   static unsigned long long calls;
   unsigned long long number = 0;
#ifndef _WIN32
   int source = open("/dev/urandom", O_RDONLY);
   if (source >= 0) {
      if (read(source, &number, sizeof number) != (ssize_t)sizeof number) number = 0;
      close(source);
   }
#endif
   if (number == 0)
      number = (unsigned long long)time(NULL)*6364136223846793005ULL
         + (unsigned long long)clock()*1442695040888963407ULL;
   return number + ((unsigned long long)getpid() << 40) + calls++;
}

/* Length of the folder in front of a name, with its slash. */
static size_t folder_length(const char *path)
{
   const char *slash = strrchr(path, '/');
#ifdef _WIN32
   const char *back = strrchr(path, '\\');
   if (slash == NULL || (back != NULL && back > slash)) slash = back;
#endif
   return slash == NULL ? 0 : (size_t)(slash - path) + 1;
}

/* Creates a file of a random name in `folder` (empty or with its slash) and notes it as unfinished. */
static int create_beside(struct unfinished_file *file, const char *folder, size_t length, int mode)
{
   char name[PATH_SIZE];
   int tries;

   if (length == 0) {
      folder = "./";
      length = 2;
   }
   for (tries = 0; tries < 100; tries++) {
      int size = snprintf(name, sizeof name, "%.*s.kyvadlo-%016llx.part", (int)length, folder, random_number());
      if (size >= (int)sizeof name) return ENAMETOOLONG;
      /* The name is noted first: a signal may come as soon as the file is there. */
      file->descriptor = -1;
      strcpy(file->name, name);
      file->descriptor = open(name, O_RDWR | O_CREAT | O_EXCL | O_BINARY, mode);
      if (file->descriptor >= 0) return 0;
      file->name[0] = '\0';
      if (errno != EEXIST) return errno;
   }
   return EEXIST;
}

/* Writes all bytes. */
int kyvadlo_write(int descriptor, const char *bytes, long size)
{
   while (size > 0) {
      long count = (long)write(descriptor, bytes, (size_t)size);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) return errno;
      bytes += count;
      size -= count;
   }
   return 0;
}

/* The name under which a file is written until it is whole, for libraries that open files by name; empty for a device
   or pipe. `text` has room for `size` bytes with the NUL. */
void kyvadlo_unfinished_name(int descriptor, char *text, int size)
{
   struct unfinished_file *file = file_of(descriptor);
   snprintf(text, (size_t)size, "%s", file == NULL ? "" : file->name);
}

/* Closes the file and leaves nothing behind. */
void kyvadlo_discard_file(int descriptor)
{
   struct unfinished_file *file = file_of(descriptor);
   close(descriptor);
   if (file == NULL) return;
   if (file->old_descriptor >= 0) close(file->old_descriptor);
   unlink(file->name);
   file->name[0] = '\0';
}

/* Whether a file begins with `mark`. */
int kyvadlo_begins_with(const char *path, const char *mark)
{
   char start[256];
   size_t length = strlen(mark);
   FILE *file = fopen(path, "rb");
   int same;

   if (file == NULL || length > sizeof start) return 0;
   same = fread(start, 1, length, file) == length && memcmp(start, mark, length) == 0;
   fclose(file);
   return same;
}

/* Whether an unfinished file holds a whole picture: its first bytes and its last are those of an SVG or a PNG. */
int kyvadlo_is_whole_picture(int descriptor, int is_png)
{
   static const char png_start[] = "\211PNG\r\n\032\n", png_end[] = "IEND\256B\140\202";
   char start[8], end[16];
   long size = (long)lseek(descriptor, 0, SEEK_END);

   if (size < 100) return 0;
   if (lseek(descriptor, 0, SEEK_SET) < 0 || read(descriptor, start, sizeof start) != (int)sizeof start) return 0;
   if (lseek(descriptor, size - (long)sizeof end, SEEK_SET) < 0 || read(descriptor, end, sizeof end) != (int)sizeof end)
      return 0;
   if (is_png) return memcmp(start, png_start, 8) == 0 && memcmp(end + 8, png_end, 8) == 0;
   for (size = 0; size + 6 <= (long)sizeof end; size++)
      if (memcmp(end + size, "</svg>", 6) == 0) return start[0] == '<';
   return 0;
}

int kyvadlo_is_terminal(int descriptor)
{
   return isatty(descriptor);
}

/* The bytes that OMP_STACKSIZE gives a thread, or 0 where it says nothing that can be read. */
long kyvadlo_stack_of_threads(void)
{
   const char *text = getenv("OMP_STACKSIZE");
   char *unit;
   double size;

   if (text == NULL) return 0;
   size = strtod(text, &unit);
   while (*unit == ' ') unit++;
   switch (*unit) {
   case 'b': case 'B': break;
   case 'm': case 'M': size *= 1048576; break;
   case 'g': case 'G': size *= 1073741824; break;
   default: size *= 1024;
   }
   return size > 0 && size < 1e9 ? (long)size : 0;
}

#ifdef _WIN32
#include "system_windows.inc"
#else
#include "system_posix.inc"
#endif
