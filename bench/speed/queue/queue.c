/* queue.c - compares the event queue with others: nanoseconds of a "hold", which takes one event out and puts
 * another in, over the number of events in the queue.
 *
 * Three loads:
 *  - spread: each next event lies at a random distance; no two events have one time;
 *  - lockstep: all events have one time and differ by their addresses, as when all nodes do the same;
 *  - traffic: the events of rings, halos and all-to-all (traffic/traffic.c). A node has two events, one of
 *    its program and one of a message, at different steps of the message; the distances are those of a ring's
 *    message. One node in 16 is up to 1.6 us behind, as if it had waited for a channel, and catches up.
 *
 * Each cell is the median of RUNS runs, which alternate with those of the other queues. All queues must give
 * one order.
 */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include "kernel/evq.h"
#include "queues.h"

enum { RUNS = 5, HOLDS = 400000, RANKS = 4 }; /* RANKS: the ranks that an event has, one after the other */

struct load {
    const char *name;
    uint64_t steps[4]; /* distances of an event to its successor, by rank; 0: random */
    bool behind;       /* some nodes are behind, and every other event is half the way ahead */
};

static const struct load LOADS[] = {{"spread", {0}, false},
                                    {"lockstep", {40000000, 5000000, 100000, 35000000}, false},
                                    {"traffic", {35000000, 5000000, 40425000, 2500000}, true}};

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* The time by which an event is late: that of a node (e.rank >> 3) that is behind, at every other step. */
static uint64_t behind(struct item e)
{
    enum { CLOCK = 25000 };
    return e.rank >> 3 & 15 ? 0 : CLOCK * (1 + (e.rank >> 7 & 63));
}

/* The event that the load puts in after e has come out. */
static struct item successor(const struct load *l, struct item e, uint64_t *random)
{
    *random = *random * UINT64_C(6364136223846793005) + 1442695040888963407;
    if (!l->steps[0])
        return (struct item){e.time + 1 + (*random >> 37), e.rank};
    struct item next = {e.time + l->steps[e.rank & 3], (e.rank & ~UINT64_C(3)) | ((e.rank + 1) & 3)};
    if (l->behind)
        next.time += e.rank & 1 ? -behind(e) : behind(e);
    return next;
}

/* The predecessor of the i-th event that is put in at the start. */
static struct item origin(const struct load *l, size_t i)
{
    return (struct item){0, i << 2 | (l->behind && i & 1 ? 2 : 0)};
}

/* --- one of the structures of queues.h --- */

static double hold_queue(const struct queue *q, const struct load *l, size_t pending, uint64_t *sum)
{
    void *p = q->make();
    uint64_t random = 1;
    for (size_t i = 0; i < pending; i++)
        q->put(p, successor(l, origin(l, i), &random));
    *sum = 0;
    double begin = seconds();
    for (size_t i = 0; i < HOLDS; i++) {
        struct item e = q->take(p);
        *sum = *sum * 31 + e.time + e.rank;
        q->put(p, successor(l, e, &random));
    }
    double t = seconds() - begin;
    q->drop(p);
    return t / HOLDS;
}

/* --- touchstone's queue --- */

struct hold {
    struct evq *q;
    const struct load *load;
    uint64_t random, sum;
    char *things; /* arg of an event is the thing at its rank, which the queue prefetches */
};

static void put(struct hold *h, struct item e);

static void fire(void *ctx, void *arg, vtime now)
{
    struct hold *h = ctx;
    struct item e = {now, (uint64_t)((char *)arg - h->things)};
    h->sum = h->sum * 31 + e.time + e.rank;
    put(h, successor(h->load, e, &h->random));
}

static void put(struct hold *h, struct item e)
{
    evq_put(h->q, e.time, (uint32_t)(e.rank >> 2), fire, h, h->things + e.rank);
}

static double hold_evq(const struct load *l, size_t pending, uint64_t *sum)
{
    struct hold h = {evq_new(), l, 1, 0, calloc(pending, RANKS)};
    struct instant present = {0}, reached = {0};
    for (size_t i = 0; i < pending; i++)
        put(&h, successor(l, origin(l, i), &h.random));
    double begin = seconds();
    for (size_t i = 0; i < HOLDS; i++)
        evq_step(h.q, &present, &reached);
    double t = seconds() - begin;
    *sum = h.sum;
    evq_free(h.q);
    free(h.things);
    return t / HOLDS;
}

/* --- the table --- */

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void measure(const struct load *l, size_t pending)
{
    static const struct queue *const others[] = {&BINARY_HEAP, &PAIRING_HEAP, &LADDER};
    enum { OTHERS = sizeof others / sizeof *others };
    double t[OTHERS + 1][RUNS];
    for (int r = 0; r < RUNS; r++) {
        uint64_t right, sum;
        t[0][r] = hold_evq(l, pending, &right);
        for (int i = 0; i < OTHERS; i++) {
            t[i + 1][r] = hold_queue(others[i], l, pending, &sum);
            if (sum != right) {
                fprintf(stderr, "queue: the %s gives another order\n", others[i]->name);
                exit(1);
            }
        }
    }
    printf("%-9s %8zu", l->name, pending);
    for (int i = 0; i <= OTHERS; i++) {
        qsort(t[i], RUNS, sizeof t[i][0], by_size);
        printf(" %13.0f", 1e9 * t[i][RUNS / 2]);
    }
    putchar('\n');
}

int main(void)
{
    static const size_t pending[] = {16, 256, 1024, 4096, 16384, 131072};
    printf("ns a hold  pending           evq   binary heap  pairing heap  ladder queue\n");
    for (size_t l = 0; l < sizeof LOADS / sizeof *LOADS; l++)
        for (size_t i = 0; i < sizeof pending / sizeof *pending; i++)
            measure(&LOADS[l], pending[i]);
    return 0;
}
