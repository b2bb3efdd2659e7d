/* times.h - where a node's time goes, measured by the program itself: with -times, every change of activity
 * is stamped with dclock(). Without -times only the activity is known, and nothing measured or printed.
 *
 * A node has one activity at a time, so that the seconds of all activities add up to the node's time from
 * times_begin() to times_end(). System time that the program cannot see (receiving messages, entering and
 * leaving a handler) counts as part of the activity that it interrupts.
 */
#ifndef TIMES_H
#define TIMES_H

enum activity {
    OTHER,
    READING,       /* host: reading slices, making their data */
    HELPING,       /* host: computing subcubes */
    COMPUTING,     /* slave: computing a chunk */
    SENDING,       /* slave: requests and polygons */
    ANSWERING,     /* host's handler: requests, without packing */
    PACKING,       /* chunks */
    COLLECTING,    /* host's handler: polygons */
    NEWS,          /* host's other handlers */
    DEALING,       /* host: telling other hosts, dealing its nodes */
    WAIT_REQUESTS, /* host: until slaves have asked for the rest of a layer */
    WAIT_SLAVES,   /* host: for the last polygons */
    WAIT_CHUNK,    /* slave */
    WAIT_ORDER,    /* a node without work */
    ACTIVITIES
};

/* The clock starts, at `now` seconds. on: whether to measure; layers: those of the volume. */
void times_begin(int on, double now, int layers);
void times_end(void);

/* Begins activity a. Answers the activity before, to which the caller may return. */
enum activity times_enter(enum activity a);

/* The activity at hand. */
enum activity times_now(void);

/* A host opens a layer; -1: the last layer is closed. */
void times_layer(int layer);

/* Called by all nodes: node 0 prints the sums over hosts and over slaves, each host its layers. */
void times_print(int is_host);

#endif
