/* engine.h - what puts the machine's events, and its programs' computing, in order: for what happens to a
 * node.
 *
 * There are two engines, and touchstone is linked once with each:
 *
 *   sim/reference        the rules of time in their plainest form: one event at a time, on one thread. It
 *                        defines every result.
 *   sim/lp, os/gate.c,   the fast one. Programs compute ahead, on several threads, and calls are committed
 *   os/deferred.c, ...   before or after the programs leave them. Its results equal the reference's, to the
 *                        last digit.
 *
 * All else is shared, and has no schedule in it: it is told what happens, and at what time. os/gate.h
 * declares the other half of an engine, for what programs do. */
#ifndef LP_ENGINE_H
#define LP_ENGINE_H
#include "lp/lp.h"

/* Puts the start of the node, at time t, into the queue. */
void lp_start(struct lp *lp, vtime t);
/* At time t the engine asks a blocked node whether it may resume. */
void lp_wake(struct lp *lp, vtime t);
/* The same, where what the node may wait for is there from time t on: the engine may know that nobody need
 * ask. */
void lp_notify(struct lp *lp, vtime t);
/* To be called before anything is done to the node, at the present moment, that depends on how far its
 * program has come. */
void lp_synchronise(struct lp *lp);
/* A message has come to the node that no receive selects: a deferred one may. */
void lp_message_kept(struct lp *lp);
/* The program is killed, or the machine stops, at this moment: what it has done ahead of it has not happened.
 * True: it was computing; false: it waited, or had ended. */
bool lp_roll_back(struct lp *lp, struct instant at);
/* The program's requests that are not committed are cancelled: it has ended. */
void lp_forget(struct lp *lp);

/* --- for the machine --- */

/* "reference" or "fast": which one this is. */
extern const char ENGINE_NAME[];

/* How many threads compute, and how: shuffle as in kernel/workers.h. begin and end are called on each thread
 * that does. */
struct engine_threads {
    unsigned count; /* 0 or 1: only the calling one */
    uint64_t shuffle;
    void *(*begin)(void);
    void (*end)(void *own);
    void (*hurry)(pthread_t thread); /* workers.h */
    void *own;                       /* of the calling thread */
};

/* Commits the machine's events until there are none, or schedule.stop is set. The threads' figures differ
 * from run to run. */
struct workers_stats engine_run(struct schedule *s, const struct engine_threads *threads);
/* From schedule.look: all programs stand still, in calls or at polls, from engine_hold() to
 * engine_release(). */
void engine_hold(struct schedule *s);
void engine_release(struct schedule *s);
/* Programs that compute on other threads make no call before this time; VT_NEVER: there are none. */
vtime engine_bound(const struct schedule *s);
/* Behind it: the node's books up to the moment at which the machine has stopped. */
void engine_settle(struct lp *lp, struct instant end);
#endif
