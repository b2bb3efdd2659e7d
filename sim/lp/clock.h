/* clock.h - a node's processor clock: the cost units that its program counts, and the rest of its time.
 *
 * A computing program comes to a slice boundary now and then: the first poll at or past certain numbers of
 * units since it got control calls nxc_preempt. Slice boundaries are at the same polls in every run, whatever
 * else stops the program. */
#ifndef LP_CLOCK_H
#define LP_CLOCK_H
#include "kernel/slow_assert.h"
#include "lp/lp.h"
#include "nx_api/contract/program_image.h"

/* The node's processor has so many clocks a second. */
void clock_set(struct lp *lp, uint64_t hz);
/* Virtual time of so many cost units. (Out of line here is what divides, or is rare where it is called:
 * inlined, it would take registers that all callers would have to save.) */
__attribute__((noinline, cold)) vtime clock_of_units_exactly(const struct lp *lp, uint64_t units);
static inline vtime clock_of_units(const struct lp *lp, uint64_t units)
{
    return lp->clock.unit_ps ? units * lp->clock.unit_ps : clock_of_units_exactly(lp, units);
}

/* The program has spent so many units in all. */
static inline void clock_set_units(struct lp *lp, uint64_t units)
{
    struct lp_clock *c = &lp->clock;
    c->now += c->unit_ps ? (units - c->units) * c->unit_ps
                         : clock_of_units_exactly(lp, units) - clock_of_units_exactly(lp, c->units);
    c->units = units;
}

/* The clock runs: adds what the program has spent. (Out of line for most callers: they are in calls, where
 * the clock stands still.) */
static inline void clock_count_here(struct lp *lp)
{
    struct lp_clock *c = &lp->clock;
    uint64_t spent = (uint64_t)(c->granted - *lp->budget);
    c->granted = *lp->budget;
    clock_set_units(lp, c->units + spent);
}
__attribute__((noinline)) void clock_count(struct lp *lp);
/* Synchronises the clock with what the program has spent; returns the time. */
static inline vtime clock_sync(struct lp *lp)
{
    if (lp->clock.runs)
        clock_count(lp);
    return lp->clock.now;
}

/* The program is in a call: it spends nothing until clock_allow. */
static inline vtime clock_stop(struct lp *lp)
{
    if (lp->clock.runs)
        clock_count_here(lp);
    lp->clock.runs = false;
    return lp->clock.now;
}

/* Time passes without the program: waits, system time. Call after clock_sync. */
static inline void clock_advance(struct lp *lp, vtime by)
{
    slow_assert(!lp->clock.runs || lp->clock.granted == *lp->budget); /* synchronised */
    slow_assert(lp->clock.now + by >= lp->clock.now);
    lp->clock.now += by;
}

/* The same until t >= clock_sync(lp). */
static inline void clock_advance_to(struct lp *lp, vtime t)
{
    vtime now = clock_sync(lp);
    assert(t >= now); /* a clock never goes back */
    clock_advance(lp, t - now);
}

/* The system takes t from the computing program: its commit time is so much later. */
static inline void clock_steal(struct lp *lp, vtime t)
{
    lp->clock.stolen += t;
}

/* What has been stolen becomes part of the clock's time; returns how much. Call after clock_sync. */
static inline vtime clock_add_stolen(struct lp *lp)
{
    vtime stolen = lp->clock.stolen;
    lp->clock.now += stolen;
    lp->clock.stolen = 0;
    return stolen;
}

/* What has been stolen is another's loss: the program has ended. */
static inline void clock_drop_stolen(struct lp *lp)
{
    lp->clock.stolen = 0;
}

/* The program gets control: slices begin anew. Call after clock_sync. */
void clock_begin_segment(struct lp *lp);
/* The program got control when it had spent so many units, and all earlier events were committed. */
static inline void clock_note_committed(struct lp *lp, uint64_t units)
{
    lp->segment.committed = units;
}
/* Starts the program's clock: it may spend until `deadline` (VT_NEVER: any time), or the next slice boundary:
 * the first poll at or past it calls nxc_preempt. Call after clock_sync. */
void clock_allow(struct lp *lp, vtime deadline);
/* In nxc_preempt, after clock_sync: notes a slice boundary that is reached, and where in the program the poll
 * is. */
void clock_reach_boundary(struct lp *lp, uintptr_t at);
/* And the lookahead that the program has stated. */
void clock_take_lookahead(struct lp *lp);
/* Where the program, which only computes, was at the last slice boundary before now; 0: none since it got
 * control, or too many since then. */
uintptr_t clock_last_place(const struct lp *lp);
/* How long, at least, the program, which only computes, has computed in one loop: at each slice boundary,
 * LP_LOOP of them or more, the poll was the same. 0: it is not known to be in one. */
vtime clock_time_in_loop(const struct lp *lp);
/* The program makes no call, and comes to no slice boundary, before this time, which is not before its
 * clock's. */
vtime clock_lookahead(const struct lp *lp);
/* Units that the program has yet to spend before its next call; and sets that, after handlers have run. */
uint64_t clock_lookahead_units(const struct lp *lp);
void clock_set_lookahead(struct lp *lp, uint64_t units);
/* On entering a call, after clock_stop: does the call come before the end of the lookahead that a poll has
 * given? That is a bug of nxcc's plugin (nx_api/nxcc/counting/lookahead.h). */
static inline bool clock_lookahead_is_broken(const struct lp *lp)
{
    return __builtin_expect(lp->segment.lookahead > lp->clock.units, 0);
}
/* When the program will have spent so many units, if it only computes; 0: it has. */
vtime clock_when(const struct lp *lp, uint64_t units);
/* The least units that take t. */
__attribute__((noinline)) uint64_t clock_units_in(const struct lp *lp, vtime t);
/* Units spent since the program got control. */
uint64_t clock_segment_units(const struct lp *lp);
/* The program has crashed, and may have written over its count. One that cannot be is taken back. Call before
 * clock_sync. */
void clock_doubt(struct lp *lp);
/* The program has crashed while it computed, some time after its last slice boundary. How far it had come is
 * unknown. It counts as having computed up to its next slice boundary, which is the same however it was
 * stopped before. */
void clock_crash(struct lp *lp);
/* Take back so much computing, or all there is. */
void clock_roll_back(struct lp *lp, vtime t);
/* Sets the clock of a node that is asked whether it may resume. */
static inline void clock_set_time(struct lp *lp, vtime t)
{
    lp->clock.now = t;
}
/* Back to a moment of before: after a deferred call that is rolled back. */
static inline void clock_return_to(struct lp *lp, uint64_t units, vtime t)
{
    lp->clock.units = units, lp->clock.now = t;
}
#endif
