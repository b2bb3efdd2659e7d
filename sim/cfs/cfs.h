/* cfs.h - the Concurrent File System of one machine: its I/O nodes and their disks, its directory process, and what
 * the nodes' programs call.
 *
 *   program                 client.c   pieces of a call, at most some under way at a time
 *     | messages            post.c     over the machine's network, at places behind the nodes' (topo.h)
 *   I/O nodes               ionode.c   processor, cache.c, disk.c; which has what: stripe.h
 *   directory               directory.c  names.c: open, sizes; modes.c: shared pointers
 *     |
 *   bytes                   store.c    a folder of this computer
 *
 * Calls here run on a node's stack, between node_enter and node_leave, and may wait. Where they answer -1 or NULL,
 * errno tells why.
 */
#ifndef CFS_CFS_H
#define CFS_CFS_H
#include <sys/uio.h>
#include "cfs/disk.h"
#include "cfs/ionode.h"
#include "node/file.h"
#include "node/system.h"

struct cfs;
struct cfs_file; /* a file opened by a node */
struct cfs_op;   /* a read or write under way */

/* Over sys's network, which has places for cfs_services(). dir: see store_new(). NULL with *error set. */
struct cfs *cfs_new(struct node_system *sys, const char *dir, char **error);
void cfs_free(struct cfs *c);
uint32_t cfs_services(const struct cfg_machine *cfg);
const struct node_fs *cfs_fs(struct cfs *c);

/* As protocol_nodes.work, for the places of I/O nodes and directory. */
vtime cfs_work(struct cfs *c, uint32_t place, vtime at, vtime t);

/* The file of f if it is of this file system, else NULL. */
struct cfs_file *cfs_file_of(struct node_file *f);
const char *cfs_name(const struct cfs_file *f);

/* --- reading and writing: client.c --- */

/* Starts a read or write at the file's pointer (at: -1), which goes on, or at a place, which leaves pointers alone. Data to
 * be written are taken now. NULL: EBADF. */
struct cfs_op *cfs_start(struct cfs_file *f, bool write, int64_t at, const struct iovec *parts, int count);
bool cfs_done(struct node *n, const struct cfs_op *op);
void cfs_wait(struct node *n, struct cfs_op *op);
/* Of an op that is done: puts data read in place; how many bytes were moved. Frees it. */
ssize_t cfs_end(struct cfs_op *op);

/* --- pointers, modes and sizes: names.c --- */

int64_t cfs_seek(struct cfs_file *f, int64_t offset, int whence);
int cfs_mode(const struct cfs_file *f);
int cfs_set_mode(struct cfs_file *f, int mode); /* MODE_OWN to MODE_ASYNC */
bool cfs_at_end(const struct cfs_file *f);
/* The size, after making it at least `size`. */
int64_t cfs_grow(struct cfs_file *f, uint64_t size);
/* The disks that a file is striped over: how many, and the first. */
void cfs_disks(const struct cfs_file *f, int *count, int *first);
/* Stripes an empty file over these disks. */
int cfs_restrict(struct cfs_file *f, const uint32_t *disks, uint32_t count);

struct cfs_stats {
    uint64_t reads, writes, hits, bytes_read, bytes_written, directory;
    uint64_t disk_accesses, disk_seeks, disk_rows;
    vtime disk_busy; /* of the busiest */
};
struct cfs_stats cfs_stats(const struct cfs *c);
#endif
