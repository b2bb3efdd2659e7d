/* flips.h - other orders that a recorded run could have had, each with the delays that should bring it about.
 *
 * A message race: a receive that could have got another message (Netzer & Miller, "Optimal tracing and replay
 * for debugging message-passing parallel programs", 1992). Another node sent it, the receive selects it, a
 * later receive got it or none did, and the receive does not happen before its sending. If the message that
 * won leaves later by the time between the two, the other one wins.
 *
 * An interrupt race: a handler that could have run behind the next things that its node does; or at other
 * moments before these, which no recording tells apart: some of them, at equal distances.
 *
 * As in dynamic partial-order reduction (Flanagan & Godefroid 2005) and in ISP (Vakkalanka 2009), only such
 * orders need be run: all others follow from these, or are equal to an order that has been run. */
#ifndef LAB_EXPLORE_FLIPS_H
#define LAB_EXPLORE_FLIPS_H
#include "lab/explore/clocks.h"
#include "lab/explore/run_order.h"

/* The longest delays that the machine could have had, by enum delay_kind. */
struct delay_bounds {
    int64_t most[DELAY_KINDS];
};

struct flip {
    struct digest order; /* that the event has in the other order: order_with(), order_behind() */
    uint64_t place;      /* equal for flips of one place in the program: receives or handlers of one line */
    uint32_t node;       /* where */
    bool handler;        /* its handler of the number is delayed, as far as the bound allows */
    uint64_t number;
    uint32_t from;  /* then the message of that node; then the node's start */
    uint64_t index; /* of the message; REC_UNKNOWN: there is none */
    int64_t later;  /* by so much, in picoseconds, beyond what the recorded run has */
};

struct flips {
    struct flip *list; /* malloc'd; in the order of time */
    size_t count;
};

/* All flips of a recorded run within the bounds. */
struct flips flips_of(const struct order *o, const struct clocks *c, const struct delay_bounds *bounds);

/* Adds the flip's delay to those of its run, with `margin` picoseconds more: to handler, message and start,
 * as far as each one's bound allows. False if the bounds do not allow it; *d may have changed. */
bool flip_delay(const struct flip *f, int64_t margin, const struct delay_bounds *bounds, struct delays *d);

/* A handler that is to run at or behind a time, such as that of an access that races with it. */
struct wanted_interrupt {
    uint32_t node;
    uint64_t handler; /* of the node's handlers, from 0 */
    vtime time;
};
/* Adds the flip that makes it so. False: the handler did not run, would have to run earlier, or later than
 * the bounds allow. */
bool flips_add_wanted(struct flips *all, const struct order *o, const struct delay_bounds *bounds,
                      const struct wanted_interrupt *w);
#endif
