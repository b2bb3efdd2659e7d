/* reference.c - the rules of time, in their plainest form. Everything that touchstone reports of a run is, by definition, what
 * this file makes of it. The fast engine (sim/node) has to give the same, and `make prove` looks for a program where it does not.
 *
 * 1. Events happen one at a time, in one order: by time; at one time by place (nodes' numbers), at one place as kernel/evq.h has it.
 *    What happens may put further events into the queue, at the same time or later.
 * 2. A program computes until it comes to a call, or to the first poll at or after the time of the next event. Polls are the
 *    places where nxcc lets a program look at its clock: function entries and loops. Nothing can happen before the next event: so
 *    the program may compute up to there, and has to stop then. (It stops at the first poll of all if a handler waits.)
 * 3. Wherever it has stopped, its turn is a late event at the time of its clock: it goes on after all that happens before, and
 *    after all else that happens to its node at that time.
 * 4. When the operating system needs the processor for a message, the program is put off by as long: its turn, when it has come,
 *    is put into the queue again, so much later. That is repeated until the turn comes and nothing has put it off.
 * 5. A call is made in its turn, at once and as a whole. The time it takes is added to the clock, and the program goes on from there.
 * 6. A handler that is due by the program's time runs when its turn has come at a poll, when it enters a call, and while it waits in
 *    one; not while another runs, nor while they are masked. Between two of them the program has its share (os/handlers.h).
 * 7. A call that waits does so until what it waits for is there: that is looked at in its turn, and then whenever something comes
 *    to the node.
 * 8. A program that crashes while it computes is known to have done so at its next look (lp/clock.h): the poll at which it had
 *    last stopped depends on what else happened.
 */
#include <errno.h>
#include "kernel/evq.h"
#include "kernel/fiber.h"
#include "os/charge.h"
#include "lp/clock.h"
#include "lp/engine.h"
#include "os/handlers.h"
#include "guest/isolate.h"
#include "os/mailbox.h"
#include "node/system.h"
#include "guest/trace.h"

const char ENGINE_NAME[] = "reference";

/* --- turns: rules 3 and 4 --- */

static void turn_comes(void *ctx, void *arg, vtime now);

static void put_turn(struct node *n)
{
    evq_put_late(n->sys->q, node_now(n), n->place, turn_comes, n, NULL);
}

/* The program goes on, until it switches back here: node_order, node_wait, its end or crash. */
static void run(struct node *n)
{
    isolate_run(n);
    n->state = NODE_COMPUTING;
    errno = n->saved_errno;
    fiber_resume(&n->fiber);
    n->saved_errno = errno;
    clock_sync(n);
    if (!n->crash)
        return;
    n->sys->keep_crash(n);
    if (!n->call)
        clock_crash(n);
    put_turn(n);
}

static void turn_comes(void *ctx, void *arg, vtime now)
{
    struct node *n = ctx;
    (void)arg, (void)now;
    if (n->state == NODE_ENDED)
        return;
    if (n->clock.stolen) {
        clock_advance(n, n->clock.stolen);
        n->clock.stolen = 0;
        put_turn(n);
    } else if (n->crash) {
        n->sys->crashed(n);
    } else {
        run(n);
    }
}

void node_start(struct node *n, vtime t)
{
    clock_advance_to(n, t);
    put_turn(n);
}

/* --- computing: rules 2, 3 and 6 --- */

/* Up to the next event or the limit of time, or at once if a handler waits, which a call has held back; and no longer than to the next look. */
static void compute_on(struct node *n)
{
    vtime due = handlers_armed(n) ? handlers_next_due(n) : VT_NEVER, end = n->sys->max_time;
    vtime next = vt_min(evq_next(n->sys->q), end == VT_NEVER ? VT_NEVER : end + 1);
    clock_allow(n, vt_min(next, due));
}

void node_order(struct node *n)
{
    clock_sync(n);
    put_turn(n);
    n->frame = (uintptr_t)__builtin_frame_address(0);
    fiber_yield(&n->fiber);
    if (!n->call)
        compute_on(n);
}

/* A poll has found the program's time used up. */
void node_nxc_preempt(void);
void node_nxc_preempt(void)
{
    struct node *n = node_self();
    clock_sync(n);
    clock_look(n, trace_caller(__builtin_frame_address(0)));
    n->frame = (uintptr_t)__builtin_frame_address(0);
    n->at_poll = true;
    node_order(n);
    bool any = false;
    for (; handlers_run(n, false); any = true)
        node_order(n);
    if (any) {
        node_memory_settle(n);
        clock_give(n);
        clock_given_in_turn(n, n->clock.units);
    }
    n->at_poll = false;
    compute_on(n);
}

/* --- calls: rules 5, 6 and 7 --- */

static void enter(struct node *n, const char *call)
{
    clock_stop(n);
    n->call = call;
    n->call_has_type = n->awaits = false;
    n->call_since = VT_NEVER; /* it has not come so far */
    node_order(n);
    n->call_since = node_now(n);
    while (handlers_run(n, false))
        node_order(n);
    node_memory_settle(n);
}

void node_enter(struct node *n, const char *call)
{
    n->hands_over = false;
    enter(n, call);
}

void node_enter_early(struct node *n, const char *call)
{
    n->hands_over = true;
    enter(n, call);
}

void node_leave(struct node *n)
{
    n->call = NULL;
    clock_sync(n);
    node_memory_settle(n);
    clock_give(n);
    clock_given_in_turn(n, n->clock.units);
    compute_on(n);
}

void node_spend_on(struct node *n, enum node_task task, vtime t)
{
    t = node_system_time(n, t);
    clock_sync(n);
    clock_advance(n, t);
    node_account(n, task, t);
}

void engine_post(struct node *n, struct receive *r)
{
    mailbox_post_at(n, r, node_now(n));
}

void engine_send(struct node *n, struct message *first)
{
    clock_advance_to(n, mailbox_send(n, first, node_now(n)));
}

void engine_received(struct node *n, struct message *m)
{
    node_spend_on(n, NODE_COPYING, mailbox_copying(n, m));
    mailbox_done_with(n, m, node_now(n));
}

void node_wait(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg)
{
    n->hands_over = false;
    node_order(n);
    for (;;) {
        while (handlers_run(n, !ready(n, arg)))
            node_order(n);
        if (ready(n, arg))
            return;
        n->wait.ready = ready, n->wait.arg = arg;
        n->frame = (uintptr_t)__builtin_frame_address(0);
        account_block(n, node_now(n));
        fiber_yield(&n->fiber);
    }
}

static void look(void *ctx, void *arg, vtime now)
{
    struct node *n = ctx;
    (void)arg;
    if (n->state == NODE_BLOCKED && account_unblock(n, now))
        run(n);
}

void node_wake(struct node *n, vtime t)
{
    evq_put_late(n->sys->q, t, n->place, look, n, NULL);
}

void engine_look(struct node *n, vtime t)
{
    node_wake(n, t);
}

/* --- ends --- */

void node_cut(struct node *n, struct instant at)
{
    vtime turn = node_now(n) + n->clock.stolen;
    if (n->state == NODE_BLOCKED)
        account_cut(n, at.time);
    else if (turn > at.time)
        clock_cut(n, turn - at.time);
    n->cut_short = n->state == NODE_COMPUTING;
    n->clock.stolen = 0;
}

/* Nothing has been done ahead of its time, so that nothing is to be made up for, or undone. */
void engine_touch(struct node *n)
{
    (void)n;
}

void engine_kept(struct node *n)
{
    (void)n;
}

void engine_forget(struct node *n)
{
    (void)n;
}

void engine_settle(struct node *n, struct instant end)
{
    (void)n, (void)end;
}

/* --- events: rule 1 --- */

struct workers_stats engine_run(struct node_system *s, const struct engine_threads *threads)
{
    enum { LOOK_EVERY = 256 };
    (void)threads;
    for (uint64_t i = 0; !s->stop && evq_next(s->q) != VT_NEVER; i++) {
        if (i % LOOK_EVERY == 0)
            s->look(s->look_ctx);
        if (evq_next(s->q) > s->max_time)
            node_system_end_at_limit(s);
        else
            evq_step(s->q, &s->present);
    }
    return (struct workers_stats){0};
}
