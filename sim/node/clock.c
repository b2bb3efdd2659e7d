/* clock.c - see clock.h. Units are cumulative, so that rounding does not depend on how often they are looked
 * at. */
#include "node/clock.h"
#include "node/system.h"
#include "nx_api/contract/program_image.h"

#define UNITS_PER_CLOCK ((uint64_t)NXC_UNITS_PER_CLOCK)

/* Looks come after a quarter of a millisecond of an i860, then each as much later as has passed, up to 8 ms. */
#define FIRST_LOOK (10000 * UNITS_PER_CLOCK)
#define LONGEST_LOOK (320000 * UNITS_PER_CLOCK)

void clock_set(struct node *n, uint64_t hz)
{
    uint64_t units_per_second = hz * UNITS_PER_CLOCK;
    n->clock_hz = hz;
    n->clock.unit_ps = VT_SECOND % units_per_second ? 0 : VT_SECOND / units_per_second;
}

vtime clock_of_units_exactly(const struct node *n, uint64_t units)
{
    return (vtime)((unsigned __int128)units * VT_SECOND / (n->clock_hz * UNITS_PER_CLOCK));
}

uint64_t clock_units_in(const struct node *n, vtime t)
{
    if (n->clock.unit_ps)
        return t / n->clock.unit_ps + (t % n->clock.unit_ps > 0);
    uint64_t units_per_second = n->clock_hz * UNITS_PER_CLOCK;
    return (uint64_t)(((unsigned __int128)t * units_per_second + VT_SECOND - 1) / VT_SECOND);
}

vtime node_now(struct node *n)
{
    return clock_sync(n);
}

/* --- looks --- */

static uint64_t least(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

void clock_give(struct node *n)
{
    uint64_t units = n->clock.units;
    n->looks.quiet = 0;
    n->looks.given_at = units;
    n->looks.look = units + FIRST_LOOK;
}

uint64_t clock_promised(const struct node *n)
{
    return n->looks.quiet > n->clock.units ? n->looks.quiet - n->clock.units : 0;
}

void clock_promise(struct node *n, uint64_t units)
{
    uint64_t until = n->clock.units + units;
    if (until > n->looks.quiet)
        n->looks.quiet = until;
}

void clock_look(struct node *n, uintptr_t at)
{
    struct node_looks *l = &n->looks;
    if (l->look <= n->clock.units)
        n->beside->looks[n->beside->look_count++ % NODE_LOOKS] = (struct node_look){n->clock.units, at};
    while (l->look <= n->clock.units)
        l->look += least(l->look - l->given_at, LONGEST_LOOK);
}

void clock_look_ahead(struct node *n)
{
    if (*n->quiet < n->clock.given)
        clock_promise(n, (uint64_t)(n->clock.given - *n->quiet));
}

uintptr_t clock_looked_at(const struct node *n)
{
    const struct node_beside *b = n->beside;
    for (uint32_t i = 0; i < b->look_count && i < NODE_LOOKS; i++) {
        const struct node_look *look = &b->looks[(b->look_count - 1 - i) % NODE_LOOKS];
        if (look->units <= n->clock.units)
            return look->units >= n->looks.known_at ? look->at : 0;
    }
    return 0;
}

/* When it will have spent so many, or had, if it only computes. */
static vtime clock_at(const struct node *n, uint64_t units)
{
    return n->clock.now + clock_of_units(n, units) - clock_of_units(n, n->clock.units);
}

vtime clock_when(const struct node *n, uint64_t units)
{
    return units > n->clock.units ? clock_at(n, units) : 0;
}

vtime clock_quiet(const struct node *n)
{
    const struct node_clock *c = &n->clock;
    uint64_t quiet = least(n->looks.quiet, n->looks.look);
    return quiet > c->units ? clock_at(n, quiet) : c->now;
}

uint64_t clock_stretch(const struct node *n)
{
    return n->clock.units - n->looks.given_at;
}

void clock_crash(struct node *n)
{
    clock_stop(n);
    clock_set_units(n, n->looks.look);
}

/* Does not depend on how far the program had run ahead. */
void clock_cut(struct node *n, vtime t)
{
    clock_sync(n);
    vtime computed = clock_of_units(n, n->clock.units);
    clock_set_units(n, computed > t ? clock_units_in(n, computed - t) : 0);
}

/* Where a unit is no whole number of picoseconds, it depends on how many have been spent. */
static __attribute__((noinline)) uint64_t units_until_exactly(const struct node *n, vtime t)
{
    const struct node_clock *c = &n->clock;
    uint64_t units = clock_units_in(n, t - c->now);
    while (units > 0 && clock_at(n, c->units + units - 1) >= t)
        units--;
    while (clock_at(n, c->units + units) < t)
        units++;
    return units;
}

/* So many units it has to spend to come to t or behind it. */
static inline uint64_t units_until(const struct node *n, vtime t)
{
    const struct node_clock *c = &n->clock;
    if (!c->unit_ps)
        return units_until_exactly(n, t);
    return (t - c->now + c->unit_ps - 1) / c->unit_ps;
}

void clock_allow(struct node *n, vtime deadline)
{
    struct node_clock *c = &n->clock;
    uint64_t units = n->looks.look - c->units;
    if (n->sys->longest_slice)
        units = least(units, clock_units_in(n, n->sys->longest_slice));
    if (deadline <= c->now)
        units = 1;
    else if (deadline != VT_NEVER)
        units = least(units, units_until(n, deadline));
    /* A check finds *left negative once more than `given` units are spent: one less than may pass. */
    c->given = (int64_t)units - 1;
    *n->left = c->given;
    *n->quiet = NXC_NOT_QUIET;
    clock_start(n);
}
