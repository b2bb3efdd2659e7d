/* cfs_file.h - a file of the Concurrent File System that a node's program has open. */
#ifndef CFS_CFS_FILE_H
#define CFS_CFS_FILE_H
#include <sys/types.h>
#include "guest/libc/file.h"

struct cfs_file;

/* As node_fs.open; ctx: struct cfs. The caller closes the file. */
struct node_file *cfs_open(void *ctx, struct node *n, const char *path, int flags, mode_t permissions);
/* The file of f if it is of this file system, else NULL. */
struct cfs_file *cfs_file_of(struct node_file *f);
#endif
