/* clocks.h - vector clocks (Fidge 1988, Mattern 1989) of a recording's events: which happens before which.
 *
 * The order is that of each node's program, and that of each message: its sending before its receive. What a
 * node has received counts for all that the node does later, also if its program has not looked at it. */
#ifndef LAB_EXPLORE_CLOCKS_H
#define LAB_EXPLORE_CLOCKS_H
#include "lab/explore/event_rows.h"

/* A clock has a number for each node: how many of its events happened before. */
struct clocks {
    const struct event_rows *rows;
    uint32_t *after; /* of each event, rows.nodes numbers: the clock behind it; NULL: too large */
};

/* The clocks refer to the rows. Of more than `most` numbers there are none. */
struct clocks clocks_of(const struct recording *r, const struct event_rows *t, size_t most);
void clocks_free(struct clocks *c);

/* Does the event happen before the message is sent? Without clocks: false if it is later in virtual time,
 * otherwise true. */
bool clocks_before_sending(const struct clocks *c, const struct tl_event *e, const struct rec_message *m);
#endif
