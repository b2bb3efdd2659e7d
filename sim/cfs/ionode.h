/* ionode.h - an I/O node: a processor, a block cache and some disks, each of them a queue.
 *
 *   read    request -> processor -> in the cache?  yes ----------------------> copied out (processor) -> answered
 *                                                  no -> disk, read-ahead ---^
 *   write   may it come? -> a cache block is reserved (or waits for one) -> the data -> processor -> DIRTY -> answered
 *                                                                          later, in clusters: disk
 *
 * Requests that find no idle cache block wait in a queue, first come first served, until the disk has cleaned one.
 * Read-ahead: a read that has to go to disk and is sequential (the file pointer is shared; or it follows what its node
 * read before on that disk, or what is still in the cache; or it is the file's first row there) brings what is missing around it of its group of rows, as far as there
 * are idle blocks. Groups start at multiples of their size, so that readers that come in any order share them.
 * Write-behind: a block is put into its disk's queue at once when it becomes dirty; when its turn comes, the dirty
 * blocks that lie around it go with it.
 *
 * The file's bytes are read and written (store.h) at the moment a request is answered or its data taken.
 */
#ifndef CFS_IONODE_H
#define CFS_IONODE_H
#include "cfs/disk.h"
#include "cfs/store.h"
#include "cfs/stripe.h"

struct ionode;

/* A piece of a read or write, within one block. The caller sets all up to `data`. */
struct io_request {
    bool write;
    uint32_t node;
    struct store_file *file;
    uint32_t stride; /* the file's next block on the same disk */
    bool shared;     /* the file pointer is: together the nodes read in sequence, each for itself does not */
    struct stripe piece;
    char *data; /* to or from here */
    /* the I/O node's own */
    uint32_t file_id;
    bool held, here;
    struct io_request *next;
};

struct ionode_up {
    void *ctx;
    /* A request is done with: the answer may leave. */
    void (*answer)(void *ctx, struct io_request *r, vtime now);
    /* There is room now for a write that ionode_reserve() refused. */
    void (*room)(void *ctx, struct io_request *r, vtime now);
    /* The host would not read or write the file's bytes. */
    void (*broken)(void *ctx, const struct store_file *f, int error);
};

struct ionode_stats {
    uint64_t reads, writes, hits;
    vtime busy; /* processor */
};

/* index: which of cfg->io_nodes it is. place: of its events. nodes: that may send requests. */
struct ionode *ionode_new(const struct cfg_cfs *cfg, struct evq *q, uint32_t index, uint32_t place,
                          uint32_t nodes, const struct ionode_up *up);
void ionode_free(struct ionode *io);

/* Its processor works for t, from `at` on or when it is free; returns when it has finished. */
vtime ionode_work(struct ionode *io, vtime at, vtime t);
/* A write asks whether its data may come: true, or false and up.room() later. */
bool ionode_reserve(struct ionode *io, struct io_request *r, vtime now);
/* A request, with a write's data, is in the I/O node's memory at `at`. A write need not have asked. */
void ionode_request(struct ionode *io, struct io_request *r, vtime at);

const struct ionode_stats *ionode_stats(const struct ionode *io);
/* Its disk's: 0, 1, ... NULL: it has no more. */
const struct disk_stats *ionode_disk_stats(const struct ionode *io, uint32_t which);
#endif
