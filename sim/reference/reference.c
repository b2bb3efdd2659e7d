/* reference.c - the rules of time, in their plainest form. Everything that touchstone reports of a run is,
 * by definition, what this file makes of it. The fast engine (sim/lp) has to give the same, and `make
 * prove` looks for a program where it does not.
 *
 * 1. Events happen one at a time, in one order: by time; at one time by address (nodes' numbers); at one
 *    address as kernel/evq.h has it. What happens may put further events into the queue, at the same time
 *    or later.
 * 2. A program computes until it comes to a call, or to the first poll at or after the time of the next
 *    event. Polls are the places where nxcc lets a program look at its clock: function entries and loops.
 *    Nothing can happen before the next event: so the program may compute up to there, and has to stop
 *    then. (It stops at the first poll of all if a handler waits.)
 * 3. Wherever a program has stopped, its commit time is a late event at the time of its clock: the program
 *    goes on after all that happens before, and after all else that happens to its node at that time.
 * 4. When the operating system needs the processor for a message, the program is put off by as long: its
 *    commit time, when it has come, is put into the queue again, so much later. That is repeated until
 *    nothing has put the program off.
 * 5. A call is committed at its commit time, at once and as a whole. The time that the call takes is added
 *    to the clock, and the program goes on from there.
 * 6. A handler that is due by the program's time runs at the commit time of a poll, when the program
 *    enters a call, and while it waits in one; not while another runs, nor while they are masked. Between
 *    two handlers the program has its share (os/share.h).
 * 7. A call that waits does so until what it waits for is there: that is asked at its commit time, and
 *    then whenever something comes to the node.
 * 8. A program that crashes while it computes is known to have done so at its next slice boundary
 *    (lp/clock.h): the poll at which it had last stopped depends on what else happened.
 */
#include <errno.h>
#include "lp/block.h"
#include "lp/engine.h"
#include "lp/upcalls.h"
#include "node/system.h"
#include "os/observer.h"
#include "os/charge.h"
#include "os/front.h"
#include "os/gate.h"
#include "os/handlers.h"
#include "os/match.h"
#include "os/memory.h"
#include "lp/clock.h"
#include "kernel/crossing.h"
#include "node/self.h"

const char ENGINE_NAME[] = "reference";

/* --- commit times: rules 3 and 4 --- */

static void go_on(void *ctx, void *arg, vtime now);

static void put_commit(struct lp *lp)
{
    evq_put_late(lp->schedule->q, clock_sync(lp), lp->address, go_on, lp, NULL);
}

/* The program goes on, until it switches back here: node_order, node_wait, its end or crash. */
static void run(struct lp *lp)
{
    up_program_resumes(lp);
    errno = lp->saved_errno;
    fiber_resume(&lp->fiber);
    lp->saved_errno = errno;
    lp->crashed = up_program_returns(lp);
    if (lp->crashed)
        clock_doubt(lp);
    clock_sync(lp);
    if (!lp->crashed)
        return;
    if (lp->clock.runs)
        clock_crash(lp);
    put_commit(lp);
}

static void go_on(void *ctx, void *arg, vtime now)
{
    struct lp *lp = ctx;
    (void)arg, (void)now;
    if (lp->state == LP_ENDED)
        return;
    if (lp->clock.stolen) {
        clock_add_stolen(lp);
        put_commit(lp);
    } else if (lp->crashed) {
        up_report_crash(lp);
    } else {
        run(lp);
    }
}

void lp_start(struct lp *lp, vtime t)
{
    clock_advance_to(lp, t);
    put_commit(lp);
}

/* --- computing: rules 2, 3 and 6 --- */

/* Up to the next event or the limit of time, or at once if a handler waits, which a call has held back; and
 * no longer than to the next slice boundary. */
static void compute_on(struct lp *lp)
{
    vtime due = up_is_interruptible(lp) ? up_next_interrupt(lp) : VT_NEVER;
    vtime next = vt_min(evq_next(lp->schedule->q), schedule_end_of_time(lp->schedule));
    clock_allow(lp, vt_min(next, due));
}

void node_order(struct node *n)
{
    put_commit(&n->lp);
    n->wait.frame = (uintptr_t)__builtin_frame_address(0);
    fiber_yield(&n->lp.fiber);
    if (!n->call.name)
        compute_on(&n->lp);
}

/* A poll has found the program's budget spent. */
void node_nxc_preempt(void);
void node_nxc_preempt(void)
{
    struct node *n = node_self();
    clock_sync(&n->lp);
    clock_reach_boundary(&n->lp, crossing_caller());
    n->wait.frame = (uintptr_t)__builtin_frame_address(0);
    n->wait.at_poll = true;
    node_order(n);
    bool any = false;
    for (; handlers_run(n, false); any = true)
        node_order(n);
    if (any)
        gate_begin_segment(n);
    n->wait.at_poll = false;
    compute_on(&n->lp);
}

/* --- calls: rules 5, 6 and 7 --- */

static void enter(struct node *n, const char *call)
{
    clock_stop(&n->lp);
    n->call.name = call;
    n->call.has_type = n->call.awaits = false;
    n->call.since = VT_NEVER; /* it has not come so far */
    node_order(n);
    n->call.since = node_now(n);
    ANNOUNCE(n, call_begins);
    while (handlers_run(n, false))
        node_order(n);
    node_memory_settle(n);
}

void node_enter(struct node *n, const char *call)
{
    n->call.hands_over = false;
    enter(n, call);
}

void node_enter_early(struct node *n, const char *call)
{
    n->call.hands_over = true;
    enter(n, call);
}

void node_enter_asking(struct node *n, const char *call)
{
    node_enter(n, call);
}

void node_answers(struct node *n, bool yes)
{
    (void)n, (void)yes;
}

void node_leave(struct node *n)
{
    clock_sync(&n->lp);
    ANNOUNCE(n, call_ends);
    n->call.name = NULL;
    gate_begin_segment(n);
    compute_on(&n->lp);
}

void node_spend_on(struct node *n, enum node_task task, vtime t)
{
    t = node_system_time(n, t);
    clock_sync(&n->lp);
    clock_advance(&n->lp, t);
    node_account(n, task, t);
}

void front_post(struct node *n, struct receive *r)
{
    match_post(n, r, node_now(n));
}

void front_send(struct node *n, struct message *first)
{
    clock_advance_to(&n->lp, match_send(n, first, node_now(n)));
}

void front_received(struct node *n, struct message *m)
{
    node_spend_on(n, NODE_COPYING, match_copying(n, m));
    match_done_with(n, m, node_now(n));
}

void node_wait(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg)
{
    n->call.hands_over = false;
    node_order(n);
    for (;;) {
        while (handlers_run(n, !ready(n, arg)))
            node_order(n);
        if (ready(n, arg))
            return;
        n->wait.ready = ready, n->wait.arg = arg;
        n->wait.frame = (uintptr_t)__builtin_frame_address(0);
        lp_block(&n->lp, node_now(n));
        fiber_yield(&n->lp.fiber);
    }
}

static void look(void *ctx, void *arg, vtime now)
{
    struct lp *lp = ctx;
    (void)arg;
    if (lp->state == LP_BLOCKED && lp_unblock(lp, now))
        run(lp);
}

void lp_wake(struct lp *lp, vtime t)
{
    evq_put_late(lp->schedule->q, t, lp->address, look, lp, NULL);
}

void lp_notify(struct lp *lp, vtime t)
{
    lp_wake(lp, t);
}

/* --- ends --- */

bool lp_roll_back(struct lp *lp, struct instant at)
{
    return lp_end_at(lp, at.time);
}

/* Nothing has been done ahead of its time, so that nothing is to be made up for, or undone. */
void lp_synchronise(struct lp *lp)
{
    (void)lp;
}

void lp_message_kept(struct lp *lp)
{
    (void)lp;
}

void lp_forget(struct lp *lp)
{
    (void)lp;
}

/* There is one thread. */
void engine_hold(struct schedule *s)
{
    (void)s;
}

void engine_release(struct schedule *s)
{
    (void)s;
}

vtime engine_bound(const struct schedule *s)
{
    (void)s;
    return VT_NEVER;
}

void engine_settle(struct lp *lp, struct instant end)
{
    (void)lp, (void)end;
}

/* --- events: rule 1 --- */

struct workers_stats engine_run(struct schedule *s, const struct engine_threads *threads)
{
    enum { LOOK_EVERY = 256 };
    (void)threads;
    for (uint64_t i = 0; !s->stop && evq_next(s->q) != VT_NEVER; i++) {
        if (i % LOOK_EVERY == 0)
            s->look(s->look_ctx);
        if (evq_next(s->q) > s->max_time)
            up_end_at_limit(s);
        else
            evq_step(s->q, &s->present, &s->reached);
    }
    return (struct workers_stats){0};
}
