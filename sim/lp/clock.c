/* clock.c - see clock.h. Units are cumulative: how often the clock is synchronised changes no rounding. */
#include "lp/clock.h"
#include "kernel/xalloc.h"

#define UNITS_PER_CLOCK ((uint64_t)NXC_UNITS_PER_CLOCK)

/* The first slice ends after a quarter of a millisecond of an i860, each further one after as much again as
 * has passed, at most 8 ms. */
#define FIRST_SLICE (10000 * UNITS_PER_CLOCK)
#define LONGEST_SLICE (320000 * UNITS_PER_CLOCK)

/* Hours of an i860, which no program computes from one poll to the next. */
#define MOST_AT_ONCE (UINT64_C(1) << 50)

void clock_set(struct lp *lp, uint64_t hz)
{
    uint64_t units_per_second = hz * UNITS_PER_CLOCK;
    lp->clock_hz = hz;
    lp->clock.unit_ps = VT_SECOND % units_per_second ? 0 : VT_SECOND / units_per_second;
}

vtime clock_of_units_exactly(const struct lp *lp, uint64_t units)
{
    return (vtime)((unsigned __int128)units * VT_SECOND / (lp->clock_hz * UNITS_PER_CLOCK));
}

void clock_count(struct lp *lp)
{
    clock_count_here(lp);
}

uint64_t clock_units_in(const struct lp *lp, vtime t)
{
    if (lp->clock.unit_ps)
        return t / lp->clock.unit_ps + (t % lp->clock.unit_ps > 0);
    uint64_t units_per_second = lp->clock_hz * UNITS_PER_CLOCK;
    return (uint64_t)(((unsigned __int128)t * units_per_second + VT_SECOND - 1) / VT_SECOND);
}

/* --- compute segments and their slices --- */

static uint64_t least(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

void clock_begin_segment(struct lp *lp)
{
    uint64_t units = lp->clock.units;
    lp->segment.lookahead = 0;
    lp->segment.begun = units;
    lp->segment.end = units + FIRST_SLICE;
}

uint64_t clock_lookahead_units(const struct lp *lp)
{
    return lp->segment.lookahead > lp->clock.units ? lp->segment.lookahead - lp->clock.units : 0;
}

void clock_set_lookahead(struct lp *lp, uint64_t units)
{
    uint64_t until = lp->clock.units + units;
    if (until > lp->segment.lookahead)
        lp->segment.lookahead = until;
}

/* The next boundary is one that the program has not come to yet. */
static void pass_boundaries(struct lp *lp)
{
    struct lp_segment *g = &lp->segment;
    while (g->end <= lp->clock.units && g->end - g->begun < LONGEST_SLICE)
        g->end += g->end - g->begun;
    if (g->end <= lp->clock.units)
        g->end += ((lp->clock.units - g->end) / LONGEST_SLICE + 1) * LONGEST_SLICE;
}

static __attribute__((noinline)) void note_place(struct lp *lp, uintptr_t at)
{
    if (!lp->places)
        lp->places = xcalloc(1, sizeof *lp->places);
    struct lp_places *p = lp->places;
    const struct lp_place *before = p->count ? &p->place[(p->count - 1) % LP_PLACES] : NULL;
    struct lp_place place = {.units = lp->clock.units, .at = at, .since = lp->clock.units, .same = 1};
    if (before && before->at == at && before->units > lp->segment.begun)
        place.since = before->since, place.same = before->same + 1;
    p->place[p->count++ % LP_PLACES] = place;
}

void clock_reach_boundary(struct lp *lp, uintptr_t at)
{
    if (lp->segment.end <= lp->clock.units)
        note_place(lp, at);
    pass_boundaries(lp);
}

void clock_take_lookahead(struct lp *lp)
{
    if (*lp->lookahead < lp->clock.granted)
        clock_set_lookahead(lp, (uint64_t)(lp->clock.granted - *lp->lookahead));
}

/* Of clock_last_place(): the place. NULL: there is none. */
static const struct lp_place *last_place(const struct lp *lp)
{
    const struct lp_places *p = lp->places;
    for (uint32_t i = 0; p && i < p->count && i < LP_PLACES; i++) {
        const struct lp_place *place = &p->place[(p->count - 1 - i) % LP_PLACES];
        if (place->units <= lp->clock.units)
            return place->units >= lp->segment.committed ? place : NULL;
    }
    return NULL;
}

uintptr_t clock_last_place(const struct lp *lp)
{
    const struct lp_place *place = last_place(lp);
    return place ? place->at : 0;
}

/* When the program, which only computes, will have spent so many units, or had. */
static vtime clock_at(const struct lp *lp, uint64_t units)
{
    return lp->clock.now + clock_of_units(lp, units) - clock_of_units(lp, lp->clock.units);
}

vtime clock_time_in_loop(const struct lp *lp)
{
    const struct lp_place *place = last_place(lp);
    bool loops = place && place->same >= LP_LOOP;
    return loops ? clock_of_units(lp, lp->clock.units) - clock_of_units(lp, place->since) : 0;
}

vtime clock_when(const struct lp *lp, uint64_t units)
{
    return units > lp->clock.units ? clock_at(lp, units) : 0;
}

vtime clock_lookahead(const struct lp *lp)
{
    const struct lp_clock *c = &lp->clock;
    uint64_t until = least(lp->segment.lookahead, lp->segment.end);
    return until > c->units ? clock_at(lp, until) : c->now;
}

uint64_t clock_segment_units(const struct lp *lp)
{
    return lp->clock.units - lp->segment.begun;
}

void clock_doubt(struct lp *lp)
{
    uint64_t spent = (uint64_t)lp->clock.granted - (uint64_t)*lp->budget;
    if (lp->clock.runs && spent > MOST_AT_ONCE)
        *lp->budget = lp->clock.granted;
}

void clock_crash(struct lp *lp)
{
    clock_stop(lp);
    pass_boundaries(lp);
    clock_set_units(lp, lp->segment.end);
}

/* The result does not depend on how far the program had computed ahead. */
void clock_roll_back(struct lp *lp, vtime t)
{
    clock_sync(lp);
    vtime computed = clock_of_units(lp, lp->clock.units);
    clock_set_units(lp, computed > t ? clock_units_in(lp, computed - t) : 0);
}

/* Where a unit is no whole number of picoseconds, what units take depends on how many have been spent. Those
 * that take so long from the clock's beginning are enough from anywhere: fewer may be. */
static __attribute__((noinline)) uint64_t units_until_exactly(const struct lp *lp, vtime t)
{
    const struct lp_clock *c = &lp->clock;
    uint64_t units = clock_units_in(lp, t - c->now);
    while (units > 0 && clock_at(lp, c->units + units - 1) >= t)
        units--;
    return units;
}

/* Units that the program has to spend to come to t or behind it. */
static inline uint64_t units_until(const struct lp *lp, vtime t)
{
    const struct lp_clock *c = &lp->clock;
    if (!c->unit_ps)
        return units_until_exactly(lp, t);
    return (t - c->now + c->unit_ps - 1) / c->unit_ps;
}

void clock_allow(struct lp *lp, vtime deadline)
{
    struct lp_clock *c = &lp->clock;
    /* Behind a slice boundary without a poll (a call that only waits for its turn, in between): the next
     * poll. */
    uint64_t units = lp->segment.end > c->units ? lp->segment.end - c->units : 0;
    if (lp->schedule->longest_slice)
        units = least(units, clock_units_in(lp, lp->schedule->longest_slice));
    if (deadline <= c->now)
        units = least(units, 1);
    else if (deadline != VT_NEVER)
        units = least(units, units_until(lp, deadline));
    /* A poll finds *budget negative once more than `granted` units are spent: one less than may pass. */
    c->granted = (int64_t)units - 1;
    *lp->budget = c->granted;
    *lp->lookahead = NXC_NO_LOOKAHEAD;
    c->runs = true;
}
