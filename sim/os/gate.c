/* gate.c - see gate.h: the fast engine's. */
#include "os/gate.h"
#include <inttypes.h>
#include "kernel/crossing.h"
#include "lp/block.h"
#include "lp/deferral.h"
#include "lp/dispatch.h"
#include "lp/lookahead.h"
#include "lp/offload.h"
#include "node/system.h"
#include "os/deferred.h"
#include "os/fail.h"
#include "os/handlers.h"
#include "os/match.h"
#include "os/memory.h"
#include "os/order.h"
#include "os/observer.h"
#include "lp/clock.h"
#include "node/self.h"

/* The coordinator looks at host time and signals now and then: a poll counts as so many calls. */
enum { POLL_CALLS = 64 };

/* --- calls --- */

/* A call has come before the end of its program's lookahead, on which other nodes may have relied. */
static __attribute__((noinline, cold)) void fail_lookahead(struct node *n)
{
    uint64_t spent = clock_segment_units(&n->lp);
    node_fail_in(n, __builtin_frame_address(0),
                 "%s: called after %" PRIu64
                 " cost units of computing, within the program's lookahead of %" PRIu64
                 ": a function of the program has the name of one of the C library's, the program has "
                 "written outside of its arrays (nxcc --asan finds that), or nxcc has a bug; compile with "
                 "-O0, which makes no lookahead, and report it",
                 n->call.name, spent, spent + clock_lookahead_units(&n->lp));
}

static void begin_call(struct node *n, const char *call, bool early)
{
    n->call.name = call;
    n->call.has_type = n->call.awaits = false;
    n->call.since = clock_stop(&n->lp);
    n->call.hands_over = early;
    offload_note_segment(&n->lp, call);
    if (clock_lookahead_is_broken(&n->lp))
        fail_lookahead(n);
}

/* Waits for the call's commit time. (Out of line: what most calls need has few registers then.) */
static __attribute__((noinline)) void await_commit(struct node *n)
{
    n->call.since = VT_NEVER; /* the program has not come to the call */
    node_order(n);
    n->call.since = node_now(n);
    ANNOUNCE(n, call_begins);
    while (handlers_run(n, false))
        node_order(n);
    node_memory_settle(n);
}

void node_enter(struct node *n, const char *call)
{
    begin_call(n, call, false);
    await_commit(n);
}

/* Can the call that the program is in be deferred, while the program goes on? A program worth a thread of its
 * own gets it when its call is committed. */
static bool may_defer(const struct node *n)
{
    const struct schedule *s = n->lp.schedule;
    return !n->deferred.never && n->lp.state != LP_OFFLOADED && !n->lp.clock.stolen && !s->stop &&
           n->call.since <= s->max_time && deferred_has_room(n) && !match_ignores(n) &&
           !offload_is_long_next(&n->lp) && !lp_is_passed(&n->lp, n->call.since);
}

/* The call, which may be deferred, is the next in the total order. */
static void commit_at_once(struct node *n)
{
    lp_commit(&n->lp, n->call.since);
    ANNOUNCE(n, call_begins);
    node_memory_settle(n);
}

inline void node_enter_early(struct node *n, const char *call)
{
    begin_call(n, call, true);
    if (!may_defer(n))
        await_commit(n);
    else if (n->deferred.count || !lp_is_next(&n->lp, n->call.since))
        deferred_begin(n);
    else if (schedule_has_not_looked(n->lp.schedule, 1))
        await_commit(n);
    else
        commit_at_once(n);
}

/* Is the call not the next in the total order, and can nothing reach the node up to it? Calls deferred so far
 * may only have asked, too: others change what there is to be found. */
static bool knows_what_has_come(struct node *n)
{
    return may_defer(n) && (n->deferred.count ? deferred_only_ask(n) : !lp_is_next(&n->lp, n->call.since)) &&
           lp_is_alone(&n->lp, n->call.since);
}

void node_enter_asking(struct node *n, const char *call)
{
    begin_call(n, call, false);
    n->call.asks = knows_what_has_come(n);
    if (!n->call.asks)
        await_commit(n);
}

void node_answers(struct node *n, bool yes)
{
    if (!n->call.asks)
        return;
    n->call.asks = false;
    if (yes)
        await_commit(n);
    else
        deferred_ask(n);
}

void node_leave(struct node *n)
{
    ANNOUNCE(n, call_ends);
    n->call.name = NULL;
    if (!n->deferred.open) {
        node_memory_settle(n);
        clock_note_committed(&n->lp, n->lp.clock.units);
    }
    n->deferred.open = false;
    clock_begin_segment(&n->lp);
    clock_allow(&n->lp, lp_deadline(&n->lp));
    offload_at_leave(&n->lp);
}

/* --- polls --- */

/* Looks at host time and signals, if nobody has for long. */
static void look(struct node *n)
{
    if (schedule_look_after(&n->sys->schedule, POLL_CALLS) && n->sys->schedule.stop)
        node_order(n);
}

/* Commits the poll's moment, and runs the handlers that interrupt the program there. */
static void listen(struct node *n)
{
    bool any = false;
    uint64_t lookahead = clock_lookahead_units(&n->lp);
    if (n->lp.state != LP_OFFLOADED)
        schedule_has_not_looked(&n->sys->schedule, POLL_CALLS / 8);
    do
        node_order(n);
    while (handlers_run(n, false) && (any = true));
    if (!any)
        return;
    gate_begin_segment(n);
    clock_set_lookahead(&n->lp, lookahead);
}

/* A poll has found the program's budget spent. */
void node_nxc_preempt(void);
void node_nxc_preempt(void)
{
    struct node *n = node_self();
    struct lp *lp = &n->lp;
    vtime now = clock_sync(lp);
    clock_take_lookahead(lp);
    clock_reach_boundary(lp, crossing_caller());
    n->wait.frame = (uintptr_t)__builtin_frame_address(0);
    n->wait.at_poll = true;
    if (lp->interruptible && !(lp->state == LP_OFFLOADED && now < lp->until))
        listen(n);
    else if (now > lp->schedule->max_time)
        node_order(n);
    else if (!offload_at_poll(lp, now))
        look(n);
    clock_allow(lp, lp->state == LP_OFFLOADED && !lp->interruptible ? schedule_end_of_time(lp->schedule)
                                                                    : lp_deadline(lp));
    n->wait.at_poll = false;
}

/* --- waiting --- */

/* Runs the handlers that have become due while the node came here; later ones will wake it. Returns whether
 * what the call waits for is there. */
static bool run_handlers(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg)
{
    bool is_ready = ready(n, arg);
    while (handlers_run(n, !is_ready)) {
        node_order(n);
        is_ready = ready(n, arg);
    }
    return is_ready;
}

/* Switches away until the program has something to do (lp/wake.c). True if the node has been blocked:
 * then all earlier events have been committed. */
static bool switch_away(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg)
{
    n->wait.ready = ready, n->wait.arg = arg;
    n->wait.frame = (uintptr_t)__builtin_frame_address(0);
    lp_yield(&n->lp);
    n->wait.ready = NULL;
    return n->lp.blocked_since != VT_NEVER;
}

/* Can the program go on with what the call waits for, which is there already? Nothing may reach the node
 * before the call's commit time, nor may the call itself make room for others' messages. */
static bool may_resume_early(const struct node *n, vtime now)
{
    return may_defer(n) && now <= n->sys->schedule.max_time && !match_may_grant(n) &&
           lp_is_alone(&n->lp, now);
}

void node_wait(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg)
{
    struct lp *lp = &n->lp;
    vtime now = clock_sync(lp);
    n->deferred.open = false;
    bool yields = order_must_yield(n, now), early = yields && n->call.hands_over,
         is_ready = early && ready(n, arg);
    if (is_ready && may_resume_early(n, now)) {
        deferred_resume_caller(n);
        return;
    }
    n->call.hands_over = false;
    lp_begin_wait(lp);
    if (yields) {
        if (early && !is_ready && !n->handlers.armed && !n->is_host && lp_may_block_lazily(lp, now))
            lp_block_lazily(lp);
        else
            lp_prepare_yield(lp, now);
        if (!switch_away(n, ready, arg))
            node_order(n);
    } else {
        lp_commit(lp, now);
    }
    while (!run_handlers(n, ready, arg)) {
        lp_block(lp, node_now(n));
        switch_away(n, ready, arg);
    }
}
