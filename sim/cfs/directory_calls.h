/* directory_calls.h - what nodes ask the directory process of the Concurrent File System: opening and names,
 * sizes, pointers and modes. All calls but cfs_mode, cfs_disks and cfs_at_end take time, and wait for the
 * directory's answer. */
#ifndef CFS_DIRECTORY_CALLS_H
#define CFS_DIRECTORY_CALLS_H
#include <stdbool.h>
#include <stdint.h>
#include <sys/stat.h>
#include "guest/libc/file.h"

struct cfs;
struct cfs_file;
struct store_file;

/* Opens a file for n as open() does, and gives it one more user. NULL with errno set if that is impossible.
 */
struct store_file *cfs_ask_open(struct cfs *c, struct node *n, const char *path, int flags,
                                mode_t permissions);
/* As node_fs.unlink, rename, stat and names; ctx: struct cfs. */
int cfs_unlink(void *ctx, struct node *n, const char *path);
int cfs_rename(void *ctx, struct node *n, const char *from, const char *to);
int cfs_stat_path(void *ctx, struct node *n, const char *path, struct stat *st);
char *cfs_names(void *ctx, struct node *n, const char *path);
/* As node_file_class.stat and truncate. */
int cfs_fstat(struct node_file *f, struct stat *st);
int cfs_truncate(struct node_file *f, int64_t size);

/* Sets the pointer that the file's mode uses; whence: SEEK_SET, SEEK_CUR or SEEK_END. Returns where it is
 * then, or -1. */
int64_t cfs_seek(struct cfs_file *f, int64_t offset, int whence);
int cfs_mode(const struct cfs_file *f);
int cfs_set_mode(struct cfs_file *f, int mode); /* MODE_OWN to MODE_ASYNC (modes.h) */
bool cfs_at_end(const struct cfs_file *f);
/* Makes the file at least `size` bytes long; returns its size then, or -1. */
int64_t cfs_grow(struct cfs_file *f, uint64_t size);
/* The disks that a file is striped over: how many, and the first. */
void cfs_disks(const struct cfs_file *f, int *count, int *first);
/* Stripes an empty file over these disks. */
int cfs_restrict(struct cfs_file *f, const uint32_t *disks, uint32_t count);

/* Frees the requests that are under way when the machine stops. */
void cfs_free_questions(struct cfs *c);
#endif
