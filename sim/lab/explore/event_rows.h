/* event_rows.h - the receives and handlers of a recording as events: of each node in the order of time, which
 * is the order of its program; and of all nodes in the order of time.
 *
 * A receive is an event when its program has the message, a handler when it runs. */
#ifndef LAB_EXPLORE_EVENT_ROWS_H
#define LAB_EXPLORE_EVENT_ROWS_H
#include "lab/explore/recording.h"

struct tl_event {
    vtime at;
    uint32_t node;
    bool handler;
    size_t index;    /* into recording.handlers or .receives */
    size_t position; /* of the node's events, from 0 */
};

struct event_rows {
    uint32_t nodes;          /* rows: the recording's nodes and the host */
    struct tl_event *events; /* count of them, sorted by node, then by time */
    size_t *first;           /* of each node, into events; first[nodes] is count */
    size_t *by_time;         /* into events: sorted by time */
    size_t count;
    size_t *of_receive; /* the event of each of recording.receives */
};

struct event_rows event_rows_of(const struct recording *r);
void event_rows_free(struct event_rows *t);

/* How many events of the node came at the time or before. */
size_t event_rows_until(const struct event_rows *t, uint32_t node, vtime time);
#endif
