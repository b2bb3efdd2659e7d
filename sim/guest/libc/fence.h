/* fence.h - the fence around the files of this computer that programs on nodes may use.
 *
 * A fence has entries: files, and folders with all that is in them. An entry may be read, or also written.
 * Names are decided by what they lead to: a link out of the fence is outside. Each function looks the file up
 * once, compares the path that the kernel gives for it, and then acts on the very file that it has looked up.
 *
 * The functions answer as their namesakes of POSIX, or with FENCE_REFUSED. f may be NULL: no fence. One node
 * at a time may call them. */
#ifndef GUEST_LIBC_FENCE_H
#define GUEST_LIBC_FENCE_H
#include <stdbool.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/types.h>

struct fence;

enum { FENCE_REFUSED = -2 };

/* A fence round nothing. */
struct fence *fence_empty(void);
/* A fence round the current folder, which may be written, and devices that hold nothing, as /dev/null. */
struct fence *fence_new(void);
/* Adds a file or folder; a file that is not there yet may be made. Returns false with errno if the folder of
 * path cannot be looked at. */
bool fence_add(struct fence *f, const char *path, bool writable);
void fence_free(struct fence *f);

int fence_open(struct fence *f, const char *path, int flags, mode_t permissions);
/* Makes a new file, directly in the folder for temporary files, too, and adds the file to the fence. */
int fence_open_temporary(struct fence *f, const char *path, int flags);
/* Whoever may not use a file may not look at it either, but for the folders on the way to an entry. */
int fence_stat(struct fence *f, const char *path, struct stat *st);
/* st_dev and st_ino tell files apart; they are not this computer's. */
int fence_fstat(struct fence *f, int fd, struct stat *st);
int fence_lstat(struct fence *f, const char *path, struct stat *st);
ssize_t fence_readlink(struct fence *f, const char *path, char *buf, size_t size);
int fence_chmod(struct fence *f, const char *path, mode_t permissions);
int fence_utimes(struct fence *f, const char *path, const struct timeval times[2]);
int fence_unlink(struct fence *f, const char *path);
int fence_mkdir(struct fence *f, const char *path, mode_t permissions);
int fence_rmdir(struct fence *f, const char *path);
int fence_rename(struct fence *f, const char *from, const char *to);

/* Of the latest refusal: the path that the name led to, whether it was to be written, and whether it may be
 * read. */
struct fence_refusal {
    const char *path;
    bool writes, readable;
};
struct fence_refusal fence_refusal(const struct fence *f);
#endif
