/* cfs_state.h - the state of the file system and of an open file. For the files of this folder only: cfs.c,
 * cfs_file.c, operation.c, directory_calls.c, unison.c. */
#ifndef CFS_CFS_STATE_H
#define CFS_CFS_STATE_H
#include "cfs/cfs.h"
#include "cfs/directory.h"
#include "cfs/ionode.h"
#include "cfs/store.h"
#include "cfs/unison.h"

struct cfs {
    struct node_system *sys;
    const struct cfg_cfs *cfg;
    struct store *store;
    struct ionode **io; /* at address first_address + i */
    struct directory *directory;
    uint32_t first_address;
    struct node_fs fs;
    struct cfs_op *ops;         /* all under way or not ended yet */
    struct question *questions; /* all under way: directory_calls.c */
    struct round *rounds;       /* of mode 4, not over: unison.c */
    uint64_t bytes_read, bytes_written;
};

struct cfs_file {
    struct node_file base;
    struct cfs *cfs;
    struct store_file *store;
    int flags;   /* of open() */
    uint64_t at; /* the node's own pointer; mode 3: where it has sought to */
    int mode;
    uint64_t round;      /* modes 3 and 4: calls made */
    uint64_t sought;     /* mode 3: the round in which it has sought last, plus 1; 0: none */
    uint32_t generation; /* of the group that it has joined */
};

/* Has each node a pointer of its own? */
static inline bool cfs_own_pointer(const struct cfs_file *f)
{
    return f->mode == MODE_OWN || f->mode == MODE_UNISON || f->mode == MODE_ASYNC;
}

/* Mode 3: has the node sought in this round? */
static inline bool cfs_has_sought(const struct cfs_file *f)
{
    return f->sought == f->round + 1;
}

static inline struct modes_group *cfs_group(const struct cfs_file *f)
{
    return &f->store->modes.group[f->mode];
}

/* Of `bytes` bytes at `at`, how many the file has. */
static inline uint64_t cfs_readable(const struct store_file *f, uint64_t at, uint64_t bytes)
{
    uint64_t left = f->size > at ? f->size - at : 0;
    return bytes < left ? bytes : left;
}

#endif
