/* clock.c - see clock.h. Units are cumulative, so that rounding does not depend on how often they are looked
 * at. */
#include "node/clock.h"
#include "node/system.h"
#include "nx_api/nxcc/image.h"

#define UNITS_PER_CLOCK ((uint64_t)NXC_UNITS_PER_CLOCK)

void clock_set(struct node *n, uint64_t hz)
{
    uint64_t units_per_second = hz * UNITS_PER_CLOCK;
    n->clock_hz = hz;
    n->unit_ps = VT_SECOND % units_per_second ? 0 : VT_SECOND / units_per_second;
}

vtime clock_of_units(const struct node *n, uint64_t units)
{
    if (n->unit_ps)
        return units * n->unit_ps;
    return (vtime)((unsigned __int128)units * VT_SECOND / (n->clock_hz * UNITS_PER_CLOCK));
}

static uint64_t units_of_time(const struct node *n, vtime t)
{
    if (n->unit_ps)
        return t / n->unit_ps + (t % n->unit_ps > 0);
    uint64_t units_per_second = n->clock_hz * UNITS_PER_CLOCK;
    return (uint64_t)(((unsigned __int128)t * units_per_second + VT_SECOND - 1) / VT_SECOND);
}

vtime clock_sync(struct node *n)
{
    struct node_clock *c = &n->clock;
    if (c->runs && n->image) {
        c->units += (uint64_t)(c->given - *n->image->left);
        c->given = *n->image->left;
    }
    return c->origin + clock_of_units(n, c->units);
}

vtime node_now(struct node *n)
{
    return clock_sync(n);
}

void clock_advance_to(struct node *n, vtime t)
{
    vtime now = clock_sync(n);
    n->clock.origin += t - now;
}

void clock_cut(struct node *n, vtime t)
{
    clock_sync(n);
    uint64_t units = units_of_time(n, t);
    n->clock.units -= units < n->clock.units ? units : n->clock.units;
}

void clock_allow(struct node *n, vtime deadline)
{
    vtime now = clock_sync(n);
    uint64_t units = deadline > now ? units_of_time(n, deadline - now) : 1;
    /* A check finds *left negative once more than `given` units are spent: one less than may pass. */
    n->clock.given = units > INT64_MAX / 2 ? INT64_MAX / 2 : (int64_t)units - 1;
    *n->image->left = n->clock.given;
}
