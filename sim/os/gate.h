/* gate.h - the way of a program into the operating system and back: entering and leaving calls, waiting in
 * them, and the polls at which the program may be interrupted. All functions are called on the node's stack.
 *
 * node_enter(), node_leave(), node_wait() are nx_api/contract/backend.h's. They are an engine's half for what
 * programs do; lp/engine.h is the other, and tells of the two engines. */
#ifndef OS_GATE_H
#define OS_GATE_H
#include "nx_api/contract/backend.h"
#include "os/memory.h"
#include "os/order.h"

/* The program gets control with all earlier events committed. Call after clock_sync. */
static inline void gate_begin_segment(struct node *n)
{
    node_memory_settle(n);
    clock_begin_segment(&n->lp);
    clock_note_committed(&n->lp, n->lp.clock.units);
}
/* What the call is about, for reports: a type, typesel or id; and that it waits for a message of this type or
 * typesel. */
static inline void gate_about(struct node *n, long type)
{
    n->call.type = type, n->call.has_type = true;
}
static inline void gate_awaits(struct node *n, long type)
{
    n->call.awaited = type, n->call.awaits = true;
}
#endif
