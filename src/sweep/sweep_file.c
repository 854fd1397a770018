/* The file of a sweep as the system sees it: a new one appears under its name with its header whole and its room on the
   disk reserved, and one run at a time holds it. What is written into it goes by NetCDF. Each returns 0 or an errno. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#ifdef _WIN32
#include <io.h>
#endif

/* Holds a file until the process ends. The lock lies far behind its last byte, out of the way of locks on data. */
static int hold(int descriptor)
{
#ifndef _WIN32
   struct flock lock;

   memset(&lock, 0, sizeof lock);
   lock.l_type = F_WRLCK;
   lock.l_whence = SEEK_SET;
   lock.l_start = (off_t)1 << 62;
   lock.l_len = 1;
#ifdef F_OFD_SETLK
   /* Unlike the older locks it is not lost when a library closes the file. */
   if (fcntl(descriptor, F_OFD_SETLK, &lock) == 0) return 0;
#else
   if (fcntl(descriptor, F_SETLK, &lock) == 0) return 0;
#endif
   return errno == EACCES ? EAGAIN : errno;
#else
   (void)descriptor;
   return 0;
#endif
}

/* Opens a file and holds it, a new one where `is_new`: EAGAIN if another run does, EEXIST if a new one is there. */
int kyvadlo_hold_file(const char *path, int is_new, int *descriptor)
{
   struct stat held, named;
   int status;

   *descriptor = open(path, is_new ? O_RDWR | O_CREAT | O_EXCL : O_RDWR, 0666);
   if (*descriptor < 0) return errno;
   status = hold(*descriptor);
   /* It may have been replaced in between. */
   if (status == 0 && (fstat(*descriptor, &held) != 0 || stat(path, &named) != 0 || held.st_ino != named.st_ino))
      status = EAGAIN;
   if (status != 0) {
      close(*descriptor);
      *descriptor = -1;
   }
   return status;
}

/* Whether an errno says that another run holds the file. */
int kyvadlo_is_held(int number)
{
   return number == EAGAIN;
}

void kyvadlo_let_go(int descriptor)
{
   if (descriptor >= 0) close(descriptor);
}

/* Lets the system write what it has of the file to the disk while the run goes on. */
void kyvadlo_start_writing(int descriptor)
{
#ifdef SYNC_FILE_RANGE_WRITE
   if (descriptor >= 0) sync_file_range(descriptor, 0, 0, SYNC_FILE_RANGE_WRITE);
#else
   (void)descriptor;
#endif
}

/* Gives a new file its last length and, if asked, its room on the disk, holds it and gives it the name of a file that
   this run holds: nobody else can have written the two meanwhile. */
int kyvadlo_begin_sweep(const char *unnamed, const char *path, int reserve, int *descriptor)
{
   struct stat found;
   int status = 0;

   *descriptor = open(unnamed, O_RDWR);
   if (*descriptor < 0) return errno;
   if (fstat(*descriptor, &found) != 0) status = errno;
   /* Variables end on four bytes. */
   if (status == 0 && ftruncate(*descriptor, (found.st_size + 3)/4*4) != 0) status = errno;
#ifdef __linux__
   if (status == 0 && reserve && fallocate(*descriptor, 0, 0, (found.st_size + 3)/4*4) != 0
      && errno != EOPNOTSUPP && errno != ENOSYS && errno != EINVAL) status = errno;
#else
   (void)reserve;
#endif
   if (status == 0) status = hold(*descriptor);
   if (status == 0 && fsync(*descriptor) != 0 && errno != EINVAL) status = errno;
   if (status == 0 && rename(unnamed, path) != 0) status = errno;
   if (status != 0) {
      unlink(unnamed);
      close(*descriptor);
      *descriptor = -1;
   }
   return status;
}

/* What a file is: -1 not there, 0 empty, 1 beginning as CDF-5 does, 2 something else. */
int kyvadlo_kind_of_sweep(const char *path)
{
   char start[4] = {0, 0, 0, 0};
   FILE *file = fopen(path, "rb");
   size_t count;

   if (file == NULL) return errno == ENOENT ? -1 : 2;
   count = fread(start, 1, sizeof start, file);
   fclose(file);
   if (count == 0) return 0;
   return memcmp(start, "CDF\005", count) == 0 ? 1 : 2;
}
