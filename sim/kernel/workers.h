/* workers.h - threads that run work ahead of the one thread that commits events.
 *
 * A piece of work is a stretch of computing that began at some time and ends with an event at a later one, not known
 * before. Until then it only tells how far it has come (reached). So an event may be committed when no work that is
 * out, waiting for a thread, running, or done and not taken back yet, could still make an earlier one:
 *
 *     hand ---> waiting ---> running ---> done ---> take          commit an event at (time, place) only
 *                  ^            |                                 if it is not after (reached, place)
 *                  +-- paused --+                                 of any work that is out
 *
 * Which thread runs what, and when, changes no result: the rule above makes the order of events the same. The work
 * that has come the least far is run first, because it is what the others wait for. A committing thread that has to wait
 * runs work itself; that pauses when there is more need of events, which bring more work, than of getting on with it.
 *
 * All functions are the committing thread's, but for workers_report(), which is the work's.
 */
#ifndef WORKERS_WORKERS_H
#define WORKERS_WORKERS_H
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "kernel/vtime.h"

struct workers;

struct task {
    /* set by the caller */
    _Atomic vtime lower_bound; /* its event comes no earlier */
    uint32_t place;            /* and is at this place */
    /* the workers' own */
    atomic_bool dropped;
    bool helped; /* runs on the committing thread */
    struct task *next;
};

struct workers_calls {
    void *ctx;
    void *(*begin)(void *ctx);                 /* a thread begins; returns what is its own */
    bool (*run)(void *thread, struct task *w); /* goes on with w; true: it is done; false: it paused */
    void (*end)(void *thread);                 /* before the thread ends */
};

/* How the work went, for those who tune it. It differs from run to run. */
struct workers_stats {
    uint64_t handed, away, helped; /* pieces handed out, runs on the threads, runs on the committing one */
    uint64_t waits;                /* times that the committing one had nothing to do */
    double away_s, helped_s, waited_s;
};

/* threads: at least 1, beside the committing one. shuffle: not 0: hand out and pause at random, by this seed, to test
 * that it does not matter. here: what begin() would return, for the committing thread. NULL: no threads to be had. */
struct workers *workers_new(unsigned threads, uint64_t shuffle, const struct workers_calls *calls,
                            void *here);
/* Ends the threads; nothing may be running (workers_halt). */
void workers_free(struct workers *ws);

/* w goes out. It stays where it is until taken back, or until workers_halt. */
void workers_submit(struct workers *ws, struct task *w);
/* Is any work out? */
bool workers_busy(const struct workers *ws);
/* May an event at (time, place) be committed? */
bool workers_allow(struct workers *ws, vtime time, uint32_t place);
/* Nothing that is out makes an event before this time. Never later than it could be, perhaps earlier. VT_NEVER: nothing
 * is out. */
vtime workers_bound(const struct workers *ws);
/* Work that is done, which is out no more; NULL: none at the moment. */
struct task *workers_take(struct workers *ws);
/* An event at (time, place) is not allowed yet: runs work, or waits until there is work to take or the event may be
 * allowed. */
void workers_advance(struct workers *ws, vtime time, uint32_t place);
/* w, which is out, is not wanted any more: it is stopped and taken back. */
void workers_drop(struct workers *ws, struct task *w);
/* Stops all: returns when nothing runs. Nothing is taken after it. */
void workers_halt(struct workers *ws);
struct workers_stats workers_stats(const struct workers *ws);
/* Is it worth while to hand out work? Only what will take a while, is_long, and not if lately the committing thread had nothing else to
 * do meanwhile. */
bool workers_worth(struct workers *ws, bool is_long);

/* From inside w, wherever it can pause: it has come to `reached`. True: it should pause. */
bool workers_report(struct workers *ws, struct task *w, vtime reached);
#endif
