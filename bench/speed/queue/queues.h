/* queues.h - the structures that were tried for the event queue, with one interface, to be compared with
 * sim/kernel/evq.c. All give one order: by time, then rank. They are small and lack the checks of evq.c. */
#ifndef BENCH_QUEUES_H
#define BENCH_QUEUES_H
#include <stddef.h>
#include <stdint.h>

struct item {
    uint64_t time, rank; /* rank: address, late and sequence in one word, as in evq.c */
};

struct queue {
    const char *name;
    void *(*make)(void);
    void (*put)(void *q, struct item e);
    struct item (*take)(void *q); /* the earliest event; the queue must not be empty */
    void (*drop)(void *q);
};

extern const struct queue BINARY_HEAP, PAIRING_HEAP, LADDER;

static inline int item_before(struct item a, struct item b)
{
    return ((unsigned __int128)a.time << 64 | a.rank) < ((unsigned __int128)b.time << 64 | b.rank);
}
#endif
