/* offload.c - see offload.h. */
#include "lp/offload.h"
#include <assert.h>
#include <stddef.h>
#include "lp/clock.h"
#include "lp/dispatch.h"
#include "lp/lookahead.h"
#include "lp/run_program.h"
#include "lp/upcalls.h"

/* In cost units. A segment is worth a thread of its own when it takes a few microseconds of host time; a
 * paused program is when it takes half as long as the longest slice. */
#define LONG_SEGMENT (UINT64_C(80000) * NXC_UNITS_PER_CLOCK)
#define LONG_WAY (UINT64_C(160000) * NXC_UNITS_PER_CLOCK)

static struct lp *lp_of(struct task *t)
{
    return (struct lp *)((char *)t - offsetof(struct lp, offload.task));
}

static void offload(struct lp *lp, vtime lower_bound)
{
    lp_become(lp, LP_OFFLOADED);
    lp->offload.task.address = lp->address;
    atomic_store_explicit(&lp->offload.task.lower_bound, lower_bound, memory_order_relaxed);
}

/* --- segments that are probably long: those behind the same call as a long one before --- */

/* A set of one call, or few: by the position of its name in a page, the same in every run. */
static uint64_t set_of(const char *call)
{
    return UINT64_C(1) << ((uintptr_t)call % 4096 / 8 % 64);
}

/* (Segments that could not be offloaded do not count.) */
void offload_note_segment(struct lp *lp, const char *call)
{
    struct lp_offload *o = &lp->offload;
    if (!lp->schedule->workers)
        return;
    if (!lp->interruptible && clock_segment_units(lp) >= LONG_SEGMENT)
        o->long_after |= o->last;
    else if (!lp->interruptible)
        o->long_after &= ~o->last;
    o->last = set_of(call);
}

bool offload_is_long_next(const struct lp *lp)
{
    return lp->schedule->workers && (lp->offload.long_after & lp->offload.last);
}

/* Is the program one that any thread may run until its next call? */
static bool may_offload(const struct lp *lp, bool is_long)
{
    const struct schedule *s = lp->schedule;
    return s->workers && !lp->interruptible && !up_in_handler(lp) && workers_worth(s->workers, is_long);
}

/* What comes next may be on another thread. */
static void offload_here(struct lp *lp)
{
    lp->task_paused = true;
    offload(lp, clock_sync(lp));
    lp_yield(lp);
}

void offload_at_leave(struct lp *lp)
{
    if (!up_has_deferred(lp) && may_offload(lp, offload_is_long_next(lp)))
        offload_here(lp);
}

bool offload_at_poll(struct lp *lp, vtime now)
{
    if (lp->state == LP_OFFLOADED) {
        lp->task_paused = workers_report(lp->schedule->workers, &lp->offload.task, now);
        if (lp->task_paused)
            lp_yield(lp);
        return true;
    }
    if (!may_offload(lp, clock_segment_units(lp) >= LONG_SEGMENT / 2))
        return false;
    lp_drain(lp);
    offload_here(lp);
    return true;
}

/* --- tasks --- */

bool offload_run(struct task *t)
{
    struct lp *lp = lp_of(t);
    lp->task_paused = false;
    up_prefetch_node(lp);
    up_prefetch_program(lp);
    lp_run(lp);
    return lp->crashed || !lp->task_paused;
}

void offload_take_back(struct task *t)
{
    struct lp *lp = lp_of(t);
    assert(lp->crashed || lp->arrived >= t->lower_bound);
    lp_become(lp, LP_COMPUTING);
    lp->until = 0;
    if (lp->crashed)
        lp_crash(lp);
    else
        lp_prepare_yield(lp, lp->arrived);
}

void offload_drop(struct lp *lp)
{
    if (lp->state == LP_OFFLOADED) {
        if (lp->schedule->workers)
            workers_drop(lp->schedule->workers, &lp->offload.task);
        lp_become(lp, LP_COMPUTING);
    }
    lp->until = 0;
}

/* --- programs paused at polls --- */

/* Does the program compute so many units at least before it makes a call, or anything reaches it, if no poll
 * time comes before `bound`? */
static bool has_so_far(const struct lp *lp, vtime bound, uint64_t units)
{
    const struct schedule *s = lp->schedule;
    vtime then = lp->poll_time + clock_of_units(lp, units);
    return s->polls.time[lp->address] >= then && !lp->clock.stolen &&
           protocol_horizon(s->protocol, lp->address, bound) >= then;
}

static void offload_one(struct lp *lp, vtime bound)
{
    const struct schedule *s = lp->schedule;
    lp->until = vt_min(s->polls.time[lp->address], protocol_horizon(s->protocol, lp->address, bound));
    lp_leave_poll(lp);
    offload(lp, lp->poll_time);
    workers_submit(s->workers, &lp->offload.task);
}

/* The next that has so many units to compute at least, from an address on, which becomes the one behind it.
 * NULL: none. */
static struct lp *next_with(struct schedule *s, uint32_t *address, vtime bound, uint64_t units)
{
    while (*address < s->polls.room) {
        uint32_t at = (*address)++;
        struct lp *lp = s->polls.time[at] != VT_NEVER ? up_lp_at(s, at) : NULL;
        if (lp && has_so_far(lp, bound, units))
            return lp;
    }
    return NULL;
}

/* Are two segments long? One alone gains nothing from a worker. */
static bool are_two_long(struct schedule *s, vtime bound)
{
    uint32_t address = 0;
    return next_with(s, &address, bound, LONG_WAY) && next_with(s, &address, bound, LONG_WAY);
}

bool offload_paused(struct lp *lp)
{
    struct schedule *s = lp->schedule;
    if (!s->workers)
        return false;
    vtime bound = mintree_least(&s->polls);
    bool worth = has_so_far(lp, bound, LONG_WAY) && are_two_long(s, bound), any = false;
    if (!workers_worth(s->workers, worth))
        return false;
    uint32_t address = 0;
    while ((lp = next_with(s, &address, bound, worth ? LONG_WAY : 1)))
        offload_one(lp, bound), any = true;
    return any;
}
