/* store.h - the bytes of /cfs: plain files in a folder of this computer, one for each file of the file
 * system.
 *
 * A store keeps a struct store_file for each file opened in this run, under its path within /cfs, until the
 * file has neither name nor users. The file system reads and writes bytes here at the moment its I/O nodes
 * do, and nowhere else: so what a program finds depends on virtual time alone. Folders are made as files need
 * them.
 */
#ifndef CFS_STORE_H
#define CFS_STORE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/stat.h>
#include "cfs/modes.h"

struct store;
struct dir_request;

struct store_file {
    uint32_t id;   /* changes with O_TRUNC, to a higher one: caches may hold blocks of the old file */
    uint32_t slot; /* among the files that there are: another's when this one is gone */
    struct store *store;
    char *path; /* within /cfs, as "a/b" */
    uint64_t size;
    uint32_t users; /* open files and calls under way; while there are any, host is open */
    int host;
    bool gone; /* removed: its bytes stay until it has no users */
    bool writable;
    uint32_t *volumes; /* the disks it is striped over, in order; NULL: all */
    uint32_t volume_count;
    struct modes modes;
    struct dir_request
        *waiting; /* mode 2: calls whose turn has not come, in the order they came: operation.c */
    struct store_file *next, **link;
};

/* The folder dir is made if missing. dir NULL: a temporary folder, made when needed and removed by
 * store_free(). Returns NULL with *error set (malloc'd) if the folder cannot be used. */
struct store *store_new(const char *dir, char **error);
void store_free(struct store *s);
/* Why the temporary folder cannot be made, for the user; NULL: it can, or none was needed yet. */
const char *store_failure(const struct store *s);

/* All functions return 0, or an error number (errno.h). Paths are whole, "/cfs/..."; ".." is not allowed in
 * them. A symbolic link that leads out of the store's folder is not followed: EACCES. */
int store_open(struct store *s, const char *path, int flags, mode_t permissions, struct store_file **file);
int store_unlink(struct store *s, const char *path);
int store_rename(struct store *s, const char *from, const char *to);
int store_stat(struct store *s, const char *path, struct stat *st);
/* Sets *names, for free(): guest/libc/folder_names.h. */
int store_names(struct store *s, const char *path, char **names);

void store_hold(struct store_file *f); /* one more user */
void store_release(struct store_file *f);

/* Bytes past the end of the file read as 0. */
int store_read(struct store_file *f, uint64_t at, void *buf, size_t bytes);
int store_write(struct store_file *f, uint64_t at, const void *buf, size_t bytes);
int store_grow(struct store_file *f, uint64_t size);
int store_cut(struct store_file *f, uint64_t size); /* or grow it */
int store_fstat(struct store_file *f, struct stat *st);
#endif
