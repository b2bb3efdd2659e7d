/* gate.h - the way of a program into the operating system and back: entering and leaving calls, waiting in them, and the polls at
 * which the program may be interrupted. All functions are called on the node's stack.
 *
 * This is an engine's half for what programs do; lp/engine.h is the other, and tells of the two engines. */
#ifndef OS_GATE_H
#define OS_GATE_H
#include "lp/clock.h"
#include "node/self.h"

/* The node's time now, its computing included. */
static inline vtime node_now(struct node *n)
{
    return clock_sync(&n->lp);
}
/* Enters a call: synchronises the clock, waits for the call's commit time, runs handlers due. */
void node_enter(struct node *n, const char *call);
/* The same for a call that only hands something over, or first does that and then waits (node_wait): the program goes on at
 * once, and the call is committed at its commit time (os/deferred.h). */
void node_enter_early(struct node *n, const char *call);
/* Waits until the node's present time is committed, as node_enter does, but runs no handlers: for library calls that show
 * something to the outside (a write) in places that are not safe for a handler. */
void node_order(struct node *n);
/* Waits in a call until all earlier events of the machine are committed and ready(n, arg) holds; then time is node_now(n).
 * Handlers due run meanwhile. ready is asked on the node's stack or the coordinator's. */
void node_wait(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg);
/* Back to the program; every node_enter ends with it. (node_order needs none.) */
void node_leave(struct node *n);

/* What the call is about, for reports: a type, typesel or id; and that it waits for a message of this type or typesel. */
static inline void gate_about(struct node *n, long type)
{
    n->call_type = type, n->call_has_type = true;
}
static inline void gate_awaits(struct node *n, long type)
{
    n->awaited = type, n->awaits = true;
}
#endif
