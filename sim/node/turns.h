/* turns.h - what the files of the fast engine share: cpu.c (the program's side), turns.c (the scheduler's), pending.c, commit.c.
 *
 * Computing runs ahead: a program's stretch between two calls is executed at once, and its next call becomes
 * an event at the time it ends. A node with an armed, unmasked handler runs only up to the horizon, the
 * earliest time at which anything may reach it (proto_horizon), and stops at the first check at or past it.
 *
 * Where it has stopped there is not an event, but a bound in node_system.checks: the time before which the program makes no
 * call. Often that is far ahead, because the program has said so (nx_api/contract/program_image.h: quiet). Until then nobody waits for
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
 * Turns that are not events - of a program that rests, of pending calls, of checks - have come when the machine has been at a
 * later moment. Where what happens at one node may happen to another in no time (a network without a hop's time, killproc), the
 * machine comes back from a place to smaller ones at the same time; so that what counts is the latest moment so far, `reached`. A
 * turn that is put before it, at that time again, has not come: it is made an event (turn_is_passed). Checks need no such care: a
 * program has always computed something before one, so that it comes later than the turn before.
 *
 * An event of a node is that it goes on (its start, a call), that pending calls have their turn or, blocked, that it looks again at
 * what it waits for (node_wake). Its checks are not events, but bounds beside the queue (node_system.checks). */
#ifndef NODE_TURNS_H
#define NODE_TURNS_H
#include "node/engine.h"
#include "node/system.h"

/* The program has come, or will, to a call at time t: then is its turn. */
void turn_put(struct node *n, vtime t);
/* It has stopped at a check, and is not gone on with before t: until then it makes no call. */
void turn_at_check(struct node *n, vtime check, vtime t);
/* The latest moment at which the machine has been. */
static inline struct instant turn_reached(const struct node_system *s)
{
    return instant_later(s->present, s->reached);
}
/* Has the machine been at a later moment than the node's turn at t? */
static inline bool turn_is_passed(const struct node *n, vtime t)
{
    return instant_before(t, n->place, turn_reached(n->sys));
}
/* Is the node's call or check at `now` the machine's earliest event? */
bool turn_is_first(struct node *n, vtime now);
/* May the program, in a call at `now`, rest? As far as is known it will be blocked there. Then no event is put for that: either
 * something comes to the node before, or it has been blocked in passing. */
bool turn_may_rest(const struct node *n, vtime now);
/* Its pending calls are made, and it is blocked if it rests, as far as their turns come before. Called before anything is done
 * to the node that they could matter to. */
void turn_settle(struct node *n, struct instant before);
/* The event queue is to know of the turn of the next of its pending calls that must be made in it. */
void turn_tell(struct node *n);

/* Can nothing reach the node until t, that included? */
bool node_is_alone(const struct node *n, vtime t);
/* What happens next, an event or a node's check for messages: its time, VT_NEVER if there is none, and place. */
vtime node_next(const struct node_system *s, uint32_t *place);
/* It happens. False: there is none. */
bool node_step(struct node_system *s);
/* A program that has been let off makes up for it: it computes up to the first check at or past t, or its call. Called before
 * anything is done to the node that depends on how far it has come. */
void node_catch_up(struct node *n, vtime t);
/* Before it yields to what is to happen before its call or check at `now`: sees to its turn there, but for a loose program, whose
 * turn node_catch sees to. */
void node_yield_turn(struct node *n, vtime now);

/* Runs a loose program on the calling thread until it comes to its next call, crashes (true), or pauses (false). */
bool node_run_ahead(struct node *n);
/* The committing thread takes a program back that is loose no more: its call becomes an event, its check a bound. */
void node_catch(struct node *n);
#endif
