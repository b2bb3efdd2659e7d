/* workers.h - threads that run tasks ahead of the coordinator, the one thread that commits events.
 *
 * A task is computing that began at some time and ends with an event at a later one, not known before. Until
 * then its lower bound tells: the event is not earlier. A task is out from its submission until it is taken
 * back: it waits for a thread, runs, or is done.
 *
 *     submit ---> waiting ---> running ---> done ---> take        commit an event at (time, address) only
 *                    ^            |                               if it is not after (lower bound, address)
 *                    +-- paused --+                               of any task that is out
 *
 * Which thread runs what, and when, changes no result: the rule above makes the order of events the same. The
 * task with the least lower bound is run first, because the others wait for it. A coordinator that has to
 * wait runs a task itself (help first); that pauses when there is more need of events, which bring more
 * tasks, than of getting on with it.
 *
 * All functions are the coordinator's, but for workers_report(), which is the task's.
 */
#ifndef KERNEL_WORKERS_H
#define KERNEL_WORKERS_H
#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "kernel/vtime.h"

struct workers;

struct task {
    /* set by the caller */
    _Atomic vtime lower_bound; /* its event comes no earlier */
    uint32_t address;          /* and is at this address */
    /* the workers' own */
    atomic_bool dropped;
    bool helped; /* runs on the coordinator */
    struct task *next;
};

struct workers_calls {
    void *ctx;
    void *(*begin)(void *ctx);                 /* a thread begins; returns what is its own */
    bool (*run)(void *thread, struct task *w); /* goes on with w; true: it is done; false: it has paused */
    void (*end)(void *thread);                 /* before the thread ends */
    void (*hurry)(pthread_t thread);           /* it is to pause, and has not for half a second */
};

/* How the tasks went, for those who tune that. The figures differ from run to run. */
struct workers_stats {
    uint64_t submitted, away, helped; /* tasks; runs on the threads, runs on the coordinator */
    uint64_t waits;                   /* times that the coordinator had nothing to do */
    double away_s, helped_s, waited_s;
};

/* threads: at least 1, beside the coordinator. shuffle: not 0: submit and pause at random, by this seed, to
 * test that it does not matter. here: what begin() would return, for the coordinator. NULL: no threads to be
 * had. */
struct workers *workers_new(unsigned threads, uint64_t shuffle, const struct workers_calls *calls,
                            void *here);
/* Ends the threads; nothing may be running (workers_halt). */
void workers_free(struct workers *ws);

/* w is out from now on. Its memory stays where it is until w is taken back, or until workers_halt. */
void workers_submit(struct workers *ws, struct task *w);
/* Is any task out? */
bool workers_busy(const struct workers *ws);
/* May an event at (time, address) be committed? */
bool workers_allow(struct workers *ws, vtime time, uint32_t address);
/* No task that is out makes an event before this time. It may be earlier than the tasks' lower bounds, never
 * later. VT_NEVER: none is out. */
vtime workers_bound(const struct workers *ws);
/* Takes back a task that is done; NULL: none at the moment. */
struct task *workers_take(struct workers *ws);
/* An event at (time, address) is not allowed yet: runs a task, or waits until there is one to take back or
 * the event may be allowed. */
void workers_advance(struct workers *ws, vtime time, uint32_t address);
/* Stops w, which is out and not wanted any more, and takes it back. */
void workers_drop(struct workers *ws, struct task *w);
/* Stops all: returns when nothing runs. Nothing is taken after it, until workers_go_on(). */
void workers_halt(struct workers *ws);
void workers_go_on(struct workers *ws);
struct workers_stats workers_stats(const struct workers *ws);
/* Is it worth while to submit a task? Only if it will take a while, is_long, and not if lately the
 * coordinator had nothing else to do meanwhile. */
bool workers_worth(struct workers *ws, bool is_long);

/* From inside w, wherever it can pause: its lower bound is this from now on, no less than before. True: it
 * should pause. */
bool workers_report(struct workers *ws, struct task *w, vtime lower_bound);
#endif
