/* cfs.h - the Concurrent File System of one machine: its I/O nodes and their disks, its directory process,
 * and what the nodes' programs call.
 *
 *   program                 cfs_file.c   a node's open file (guest/libc/file.h)
 *     |                     operation.c  reads and writes: pieces of a call, some of them under way at a time
 *     |                     directory_calls.c  opening, names, sizes, pointers: questions to the directory
 *     | messages            post.c       over the machine's network, at addresses behind the nodes' (topo.h)
 *   I/O nodes               ionode.c     processor, block_cache.c, disk.c; which disk has what: stripe.h
 *   directory               directory.c  one processor; shared pointers: modes.c, unison.c
 *     |
 *   bytes                   store.c      a folder of this computer
 *
 * This header brings all that the rest of touchstone calls. Calls of a program run on its node's stack,
 * between node_enter and node_leave, and may wait. Where they return -1 or NULL, errno says why.
 */
#ifndef CFS_CFS_H
#define CFS_CFS_H
#include "cfs/cfs_file.h"
#include "cfs/directory_calls.h"
#include "cfs/operation.h"
#include "guest/libc/file.h"
#include "node/system.h"

struct cfs;

/* Makes the file system on sys's network, which has addresses for cfs_services(). dir: see store_new().
 * Returns NULL with *error set (malloc'd) if the folder cannot be used. */
struct cfs *cfs_new(struct node_system *sys, const char *dir, char **error);
void cfs_free(struct cfs *c);
/* How many addresses the file system needs: for I/O nodes and directory. 0: the machine has none. */
uint32_t cfs_services(const struct cfg_machine *cfg);
const struct node_fs *cfs_fs(struct cfs *c);

/* As endpoint_work, for the addresses of I/O nodes and directory. */
vtime cfs_work(struct cfs *c, uint32_t address, vtime at, vtime t);

struct cfs_stats {
    uint64_t reads, writes, hits, bytes_read, bytes_written, directory;
    uint64_t disk_accesses, disk_seeks, disk_rows;
    vtime disk_busy; /* of the busiest */
};
struct cfs_stats cfs_stats(const struct cfs *c);
#endif
