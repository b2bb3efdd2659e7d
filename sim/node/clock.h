/* clock.h - a node's processor clock: cost units counted by the program, and the rest of its time.
 *
 * While a program computes it is looked at now and then: the first check at or past certain numbers of units since it
 * got control calls nxc_preempt. Looks come at the same checks in every run, whatever else stops the program. */
#ifndef NODE_CLOCK_H
#define NODE_CLOCK_H
#include "node/node.h"
#include "nx_api/contract/program_image.h"

/* The node's processor has so many clocks a second. */
void clock_set(struct node *n, uint64_t hz);
/* Virtual time of so many cost units. */
vtime clock_of_units_exactly(const struct node *n, uint64_t units);
static inline vtime clock_of_units(const struct node *n, uint64_t units)
{
    return n->clock.unit_ps ? units * n->clock.unit_ps : clock_of_units_exactly(n, units);
}

/* The program has spent so many units. */
static inline void clock_set_units(struct node *n, uint64_t units)
{
    struct node_clock *c = &n->clock;
    c->now += clock_of_units(n, units) - clock_of_units(n, c->units);
    c->units = units;
}

/* Take up what the program has spent since the last time; returns the time. */
static inline vtime clock_sync(struct node *n)
{
    struct node_clock *c = &n->clock;
    if (c->runs) {
        clock_set_units(n, c->units + (uint64_t)(c->given - *n->left));
        c->given = *n->left;
    }
    return c->now;
}

/* The program has control, with what it may yet spend: it may have spent some whenever the time is asked for. */
static inline void clock_start(struct node *n)
{
    n->clock.runs = true;
}

/* The program is in a call: it spends nothing until clock_start. */
static inline vtime clock_stop(struct node *n)
{
    clock_sync(n);
    n->clock.runs = false;
    return n->clock.now;
}

/* Time goes on without the program: wait, system. Call after clock_sync. */
static inline void clock_advance(struct node *n, vtime by)
{
    n->clock.now += by;
}

/* The same until t >= clock_sync(n). */
static inline void clock_advance_to(struct node *n, vtime t)
{
    clock_advance(n, t - clock_sync(n));
}

/* The program gets control: the looks begin anew. Call after clock_sync. */
void clock_give(struct node *n);
/* It got control when it had spent so many units, and all that has happened before is known. */
static inline void clock_given_in_turn(struct node *n, uint64_t units)
{
    n->looks.known_at = units;
}
/* Starts the program's clock: it may spend until `deadline` (VT_NEVER: any time), or the next look: the first check at or past it calls
 * nxc_preempt. Call after clock_sync. */
void clock_allow(struct node *n, vtime deadline);
/* In nxc_preempt, after clock_sync: notes a look that is due, and where in the program it is. */
void clock_look(struct node *n, uintptr_t at);
/* And what the program says of its next call. */
void clock_look_ahead(struct node *n);
/* Where the program, which only computes, was at the last look before now; 0: there has been none since it got control, or too
 * many since then. */
uintptr_t clock_looked_at(const struct node *n);
/* The program makes no call, and is not looked at, before this time, which is not before its clock's. */
vtime clock_quiet(const struct node *n);
/* Units that it has yet to spend before its next call; and that is what it has: handlers have run meanwhile. */
uint64_t clock_promised(const struct node *n);
void clock_promise(struct node *n, uint64_t units);
/* When it will have spent so many units, if it only computes; 0: it has. */
vtime clock_when(const struct node *n, uint64_t units);
/* The least units that take t. */
uint64_t clock_units_in(const struct node *n, vtime t);
/* Units spent since the program got control. */
uint64_t clock_stretch(const struct node *n);
/* The program has crashed while it computed, some time after its last look: how far it had come nobody knows, and it counts as
 * having computed up to its next look, which is the same however it was stopped before. */
void clock_crash(struct node *n);
/* Take back so much computing, or all there is. */
void clock_cut(struct node *n, vtime t);
#endif
