/* stripes.h - what pfs/pfs.h asks of a backend: a file's stripes, and the file system that it is on. */
#ifndef CALLS_STRIPES_H
#define CALLS_STRIPES_H
#include <stdbool.h>
#include <stdint.h>
#include "nx_api/calls/backend.h"

struct stripes {
    bool own;         /* the file is on the machine's own file system */
    int64_t capacity; /* bytes of the file system */
    int64_t free;     /* of them */
    long block;       /* the best size of a transfer, bytes */
    int unit;         /* of the file: bytes, disks, first disk; 0 if it is on another file system */
    int factor, start;
};

/* 0, or -1 with errno. In a call. */
int stripes_of_path(struct node *n, const char *path, struct stripes *s);
int stripes_of_file(struct node *n, int fd, struct stripes *s);
int stripes_set(struct node *n, int fd, int factor, int start);

/* Of the program that calls: 8, or 4 (nxcc --long32). */
size_t nx_long_bytes(const struct node *n);

/* fcntl of F_GETSATTR, F_SETSATTR and F_PFS_SVR_BUF. */
static inline bool stripes_are_meant(int what)
{
    return what >= 0x5001 && what <= 0x5003; /* pfs/pfs.h */
}
int nx_stripes_control(int fd, int what, void *argument);

#endif
