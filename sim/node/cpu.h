/* cpu.h - the order in which a node's program, the operating system and handlers have its processor.
 *
 * Computing runs ahead: a program's stretch between two calls is executed at once, and its next call becomes
 * an event at the time it ends. A node with an armed, unmasked handler runs only up to the horizon, the
 * earliest time at which anything may reach it (proto_horizon), and stops at the first check at or past it.
 *
 * Where it has stopped there is not an event, but a bound in node_system.checks: the time before which the program makes no
 * call. Often that is far ahead, because the program has said so (nx_api/nxcc/image.h: quiet). Until then nobody waits for
 * it, so that it is gone on with when all others have come so far, and computes at once what it would have computed in many
 * slices. If a message comes to it before, it is first brought to where it would be (node_catch_up).
 *
 * A call that only hands something over is pending until its turn comes, and the program computes on (pending.h).
 *
 * With workers (kernel/workers.h), a long stretch of a program without such a handler is handed out: then it is loose, and
 * runs on any thread, beside others, until its next call (or crash, or the end of time). While it is loose, it and the
 * thread that runs it have
 *     the program's memory and heap, the node's clock (all but stolen), its part of the C library, errno
 * and the committing thread has all else of the node: mailbox, state, statistics. Calls are only ever served on the
 * committing thread, in order; so are all library calls that show something to the outside.
 *
 * Programs with such a handler that have stopped at checks are lent, at once, when two of them have far to go before anything
 * can reach any of them: they are loose until then, or the end of their promises.
 *
 * System time. A message that reaches a computing node takes its processor for a while (node_work): the time
 * is noted as stolen and the node's next call or check is put back by it. The horizon is never past such a
 * moment, so it does not matter into how many slices the computing was cut.
 *
 * Handlers run on the program's own stack, inside node_enter, node_wait or nxc_preempt; not inside each
 * other.
 */
#ifndef NODE_CPU_H
#define NODE_CPU_H
#include "node/node.h"

/* Wait in a call until all earlier events of the machine have happened (node_order) and ready(n, arg); then time is
 * node_now(n). Handlers due are run meanwhile. ready is asked on the node's stack or the scheduler's: a program is not
 * switched to only to find that it has to wait. */
void node_wait(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg);
/* A blocked node looks again at what it waits for at time t. */
void node_wake(struct node *n, vtime t);
/* Can nothing reach the node until t, that included? */
bool node_is_alone(const struct node *n, vtime t);
/* What takes an ordinary node's system t takes this one's so long; and it has. */
vtime node_system_time(const struct node *n, vtime t);
void node_account(struct node *n, enum node_task task, vtime t);
/* The program is killed: it has waited until then, or what it has done ahead of it has not happened. */
void node_cut(struct node *n, struct instant at);
/* Run the handlers that are due. True if any ran. */
bool node_run_handlers(struct node *n);
/* Scheduler: what happens next, an event or a node's check for messages: its time, VT_NEVER if there is none, and place. */
vtime node_next(const struct node_system *s, uint32_t *place);
/* It happens. False: there is none. */
bool node_step(struct node_system *s);
/* A program that has been let off makes up for it: it computes up to the first check at or past t, or its call. Called before
 * anything is done to the node that depends on how far it has come. */
void node_catch_up(struct node *n, vtime t);
/* The same, up to the event that happens now: of equal times, their places say whether a check comes before it. */
void node_catch_up_now(struct node *n);
/* Before it yields to what is to happen before its call or check at `now`: sees to its turn there, but for a loose program, whose
 * turn node_catch sees to. */
void node_yield_turn(struct node *n, vtime now);
/* Put the node's start, at time t, into the queue. */
void node_start(struct node *n, vtime t);

/* Runs a loose program on the calling thread until it comes to its next call, crashes (true), or pauses (false). */
bool node_run_ahead(struct node *n);
/* The committing thread takes a program back that is loose no more: its call becomes an event, its check a bound. */
void node_catch(struct node *n);
#endif
