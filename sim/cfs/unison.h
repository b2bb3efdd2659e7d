/* unison.h - I/O mode 4: all nodes make the same calls, and one read or write serves all.
 *
 * A round is one call of every node. The node that comes first reads or writes, as in mode 0. The news - what
 * was read, or that the data are written - then goes from node to node down a tree, as forced messages,
 * whether or not a node has made its call yet:
 *
 *     0 -----------> 4 -----> 6 -> 7      numbers count from the node that came first; each sends to the
 *     | \             \-> 5                farthest first
 *     |  \-> 2 -> 3
 *      \-> 1
 *
 * A node's call is over when the message has come. Each node has a pointer of its own; all pointers move
 * alike.
 */
#ifndef CFS_UNISON_H
#define CFS_UNISON_H
#include <stdbool.h>
#include <stdint.h>
#include "kernel/vtime.h"

struct cfs;
struct cfs_file;
struct cfs_op;
struct round;

/* What a call of a round asks for, alike on all nodes. */
struct round_call {
    bool write;
    uint64_t at, asked;
};

/* The round of a node's call. The first call makes the round; *first says so. NULL: another node's call was
 * different, namely *other. */
struct round *unison_join(struct cfs_file *f, const struct round_call *call, bool *first,
                          struct round_call *other);
/* Where the pointer is after the round: the first call sets it, the others take it. */
uint64_t *unison_pointer(struct round *r);
/* The first call is over at `at`, with so many bytes, at its node: spreads the news. */
void unison_spread(struct round *r, uint32_t node, uint64_t bytes, const char *data, vtime at);
/* Another node's call is over when the news is at the node: cfs_told() is called then, or at once if the news
 * has come. */
void unison_await(struct round *r, uint32_t node, struct cfs_op *op, vtime now);
void unison_free(struct cfs *c);
#endif
