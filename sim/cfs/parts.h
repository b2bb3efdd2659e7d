/* parts.h - struct cfs, for the files of this folder that run it: cfs.c, client.c, names.c. */
#ifndef CFS_PARTS_H
#define CFS_PARTS_H
#include "cfs/cfs.h"
#include "cfs/directory.h"
#include "cfs/ionode.h"
#include "cfs/store.h"
#include "cfs/unison.h"

struct cfs {
    struct node_system *sys;
    const struct cfg_cfs *cfg;
    struct store *store;
    struct ionode **io; /* at place first_place + i */
    struct directory *directory;
    uint32_t first_place;
    struct node_fs fs;
    struct cfs_op *ops;         /* all under way or not ended yet */
    struct question *questions; /* all under way: names.c */
    struct round *rounds;       /* of mode 4, not over: unison.c */
    uint64_t bytes_read, bytes_written;
};

struct cfs_file {
    struct node_file base;
    struct cfs *cfs;
    struct store_file *store;
    int flags;   /* of open() */
    uint64_t at; /* the node's own pointer */
    int mode;
    uint64_t round;      /* modes 3 and 4: calls made */
    uint32_t generation; /* of the group that it has joined */
};

/* Has each node a pointer of its own? */
static inline bool cfs_own_pointer(const struct cfs_file *f)
{
    return f->mode == MODE_OWN || f->mode == MODE_UNISON || f->mode == MODE_ASYNC;
}

static inline struct modes_group *cfs_group(const struct cfs_file *f)
{
    return &f->store->modes.group[f->mode];
}

extern const struct node_file_class CFS_FILE; /* cfs.c */

/* What is there of `bytes` bytes at `at`. */
static inline uint64_t cfs_readable(const struct store_file *f, uint64_t at, uint64_t bytes)
{
    uint64_t left = f->size > at ? f->size - at : 0;
    return bytes < left ? bytes : left;
}

/* client.c */
void cfs_answer(void *ctx, struct io_request *r, vtime now); /* ionode_up */
void cfs_room(void *ctx, struct io_request *r, vtime now);
void cfs_free_ops(struct cfs *c);

/* names.c: node_fs */
void cfs_free_questions(struct cfs *c);
struct node_file *cfs_fs_open(void *ctx, struct node *n, const char *path, int flags, mode_t permissions);
int cfs_fs_unlink(void *ctx, struct node *n, const char *path);
int cfs_fs_rename(void *ctx, struct node *n, const char *from, const char *to);
int cfs_fs_stat(void *ctx, struct node *n, const char *path, struct stat *st);
int cfs_fstat(struct node_file *f, struct stat *st);
int cfs_truncate(struct node_file *f, int64_t size);
#endif
