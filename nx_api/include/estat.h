/* estat.h - the state of a file whose size may need more than 32 bits: estat() and festat() fill it in. */
#ifndef ESTAT_H
#define ESTAT_H
#include <sys/stat.h>
#include <sys/types.h>
#include "nx.h"
#ifdef __cplusplus
extern "C" {
#endif

/* As struct stat, but for st_size. Of files of the Concurrent File System st_mode, st_nlink, st_size,
 * st_blksize and st_blocks are known, and st_dev and st_ino, which differ for files of different names; the
 * other members are 0. */
struct estat {
    dev_t st_dev;
    ino_t st_ino;
    mode_t st_mode;
    nlink_t st_nlink;
    uid_t st_uid;
    gid_t st_gid;
    dev_t st_rdev;
    esize_t st_size;
    blksize_t st_blksize;
    blkcnt_t st_blocks;
    struct timespec st_atim, st_mtim, st_ctim; /* st_atime, st_mtime, st_ctime: sys/stat.h */
};

long estat(const char *path, struct estat *st);
long festat(int fd, struct estat *st);
long lestat(const char *path, struct estat *st); /* of a symbolic link itself */
long _estat(const char *path, struct estat *st); /* -1 and errno for an error */
long _festat(int fd, struct estat *st);
long _lestat(const char *path, struct estat *st);

#ifdef __cplusplus
}
#endif
#endif
