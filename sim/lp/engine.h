/* engine.h - the engine of a run: what puts the machine's events, and its programs' computing, in order.
 *
 * There are two, and touchstone is linked once with each:
 *
 *   sim/reference   the rules of time in their plainest form: one event at a time, on one thread. It defines every result.
 *   sim/node        cpu.c, turns.c, pending.c, commit.c: the fast one. Programs compute ahead, on several threads, and calls
 *                   are made before or after their turn. It has to give the reference's results, to the last digit.
 *
 * All other files are shared, and have no schedule in them: they are told what happens, and at what time. Beside the functions
 * below an engine serves node_enter, node_enter_early, node_order, node_spend_on and node_leave of node.h, and nxc_preempt.
 */
#ifndef NODE_ENGINE_H
#define NODE_ENGINE_H
#include "kernel/workers.h"
#include "node/node.h"

/* --- for calls, on the calling node's stack --- */

/* Waits in a call until all earlier events of the machine have happened and ready(n, arg) holds; then time is node_now(n).
 * Handlers due run meanwhile. ready is asked on the node's stack or the scheduler's. */
void node_wait(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg);
/* Posts a receive; sends messages, linked by next; gives back a message whose bytes the program has, after the system's copying. */
void engine_post(struct node *n, struct receive *r);
void engine_send(struct node *n, struct message *first);
void engine_received(struct node *n, struct message *m);

/* --- for what happens to a node --- */

/* Puts the node's start, at time t, into the queue. */
void node_start(struct node *n, vtime t);
/* A blocked node looks again at what it waits for at time t. */
void node_wake(struct node *n, vtime t);
/* The same, where what it may wait for is there from time t on: it may be known that it need not look. */
void engine_look(struct node *n, vtime t);
/* To be called before anything is done to the node, at the present moment, that depends on how far its program has come. */
void engine_touch(struct node *n);
/* A message has come that no receive selects. */
void engine_kept(struct node *n);
/* The program is killed, or the machine stops, at this moment: what it has done ahead of it has not happened. */
void node_cut(struct node *n, struct instant at);
/* What the program had asked for is not going to happen: nothing of it is wanted any more. */
void engine_forget(struct node *n);

/* --- for the machine --- */

/* "reference" or "fast": which one this is. */
extern const char ENGINE_NAME[];

/* How many threads compute, and how: shuffle as in kernel/workers.h. begin and end are called on each thread that does. */
struct engine_threads {
    unsigned count; /* 0 or 1: only the calling one */
    uint64_t shuffle;
    void *(*begin)(void);
    void (*end)(void *own);
    void *own; /* of the calling thread */
};

/* Lets the machine's events happen until there are none, or sys->stop is set. The threads' figures differ from run to run. */
struct workers_stats engine_run(struct node_system *sys, const struct engine_threads *threads);
/* Behind it: the node's books up to the moment at which the machine has stopped. */
void engine_settle(struct node *n, struct instant end);
#endif
