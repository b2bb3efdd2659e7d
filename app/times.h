/* times.h - where a node's time goes, as the program itself can tell: with -times, every change of what it
 * does is stamped with dclock(). Without, nothing is measured and nothing printed.
 *
 * A node does one thing at a time, so its seconds add up to its time from times_begin() to times_end(). What
 * interrupts an activity without the program's doing (messages that are received, the way into and out of a
 * handler) counts as part of it. On a machine that takes an interrupt between two instructions of
 * times_enter() a stretch may be booked on the wrong activity; the sum stays right.
 */
#ifndef TIMES_H
#define TIMES_H

enum activity {
    OTHER,
    READING,       /* host: slices, and making their data */
    HELPING,       /* host: computing subcubes */
    COMPUTING,     /* slave: computing a chunk */
    SENDING,       /* slave: requests and polygons */
    ANSWERING,     /* host's handler: requests, without */
    PACKING,       /* chunks */
    COLLECTING,    /* host's handler: polygons */
    NEWS,          /* host's other handlers */
    DEALING,       /* host: telling other hosts, dealing its nodes */
    WAIT_REQUESTS, /* host: until the rest of a layer is asked for */
    WAIT_SLAVES,   /* host: for the last polygons */
    WAIT_CHUNK,    /* slave */
    WAIT_ORDER,    /* a node without work */
    ACTIVITIES
};

/* The clock starts, at `now`; on: whether to measure at all. layers: in the volume. */
void times_begin(int on, double now, int layers);
void times_end(void);

/* From here on the node does `a`. Answers what it did before, to go back to. */
enum activity times_enter(enum activity a);

/* A host opens a layer; -1: it has none any more. */
void times_layer(int layer);

/* Called by all nodes: node 0 prints the sums of hosts and of slaves, each host its layers. */
void times_print(int is_host);

#endif
