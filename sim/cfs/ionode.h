/* ionode.h - an I/O node: a processor, a block cache and some disks, each of them a queue.
 *
 *   read    request -> processor -> in the cache?  yes -----------------> copied out (processor) -> answered
 *                                                  no -> disk, read-ahead -^
 *   write   request to send -> a cache block is reserved, or awaited -> data -> processor -> DIRTY, answered
 *                                                                         later, in clusters: disk
 *
 * Requests that find no idle cache block wait in a queue, first come first served, until the disk has cleaned
 * one. Read-ahead: a read is sequential if the file pointer is shared, or the read follows what its node read
 * before on that disk, or what is still in the cache, or it is of the file's first row there. A sequential
 * read that has to go to disk also brings the missing blocks of its group of rows, as far as there are idle
 * blocks. Groups start at multiples of their size, so that readers that come in any order share them.
 * Write-behind: a block that becomes dirty is put into its disk's queue at once; when the disk writes it, the
 * dirty blocks next to it are written with it.
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
    bool shared;     /* the file pointer is: the nodes together read in sequence, though no node does */
    struct stripe piece;
    char *data; /* to or from here */
    /* set by ionode.c */
    uint32_t file_id;
    bool held, here;
    struct io_request *next;
};

struct ionode_up {
    void *ctx;
    /* A request is done: the answer may leave. */
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

/* index: which of the cfg->io_nodes it is. address: where its events happen. nodes: how many may send
 * requests. */
struct ionode *ionode_new(const struct cfg_cfs *cfg, struct evq *q, uint32_t index, uint32_t address,
                          uint32_t nodes, const struct ionode_up *up);
void ionode_free(struct ionode *io);

/* Its processor works for t, from `at` on or when it is free; returns when it has finished. */
vtime ionode_work(struct ionode *io, vtime at, vtime t);
/* A write asks whether its data may come. Returns true; or false, and calls up.room() later. */
bool ionode_reserve(struct ionode *io, struct io_request *r, vtime now);
/* A request, with a write's data, is in the I/O node's memory at `at`. A write need not have asked. */
void ionode_request(struct ionode *io, struct io_request *r, vtime at);

const struct ionode_stats *ionode_stats(const struct ionode *io);
/* Of its disk number `which`, from 0 up. NULL: it has no such disk. */
const struct disk_stats *ionode_disk_stats(const struct ionode *io, uint32_t which);
#endif
