/* draw.h - delays that the machine could have had, drawn from a seed within bounds.
 *
 * Each delay is a pure function of the seed, the node, and the count of the message or interrupt on that
 * node: it depends neither on the order in which a run asks for delays nor on how often it does. Two methods:
 *
 *   random  Each delay is drawn independently: half of them are 0, an eighth at most 1 ns, so that ties are
 *           broken both ways; the others are uniform up to the bound.
 *   pct     In the manner of probabilistic concurrency testing (Burckhardt, Kothari, Musuvathi & Nagarakatte,
 *           "A Randomized Scheduler with Probabilistic Guarantees of Finding Bugs", ASPLOS 2010). Each node
 *           has a random priority. The lower it is, the more all of the node's messages and interrupts are
 *           delayed, and the slower and later it is: by 0 to half of each bound. At depth - 1 random points
 *           of the run a node's priority drops below all others: its delays are half of the bound to all of
 *           it from there on. A point is a node and a count of its messages, and of its interrupts: of the
 *           run's estimated length, counted in messages and interrupts of all nodes, each node has an equal
 *           part. */
#ifndef TIMING_DRAW_H
#define TIMING_DRAW_H
#include <stdint.h>
#include "kernel/vtime.h"

enum draw_method { DRAW_RANDOM, DRAW_PCT };

struct draw {
    uint64_t seed;
    enum draw_method method;
    uint32_t depth;  /* pct: ordering constraints of the faults that are looked for, 1 to DRAW_DEEPEST */
    uint64_t length; /* pct: of the run, in messages and interrupts; at least 1 */
    /* The bounds: the longest delay of a message, of an interrupt, of a program's start; by how many parts
     * per million a node computes slower at most. */
    vtime messages, interrupts, start;
    uint32_t speed_ppm;
};

enum { DRAW_DEEPEST = 100, DRAW_SLOWEST_PPM = 10000000 };

/* What --timing has without suboptions, but for the seed. */
struct draw draw_usual(void);
/* What is drawn for one node of a run. */
struct draw_node {
    const struct draw *draw;
    uint32_t nodes, node; /* how many there are, with the host, which is the last; which of them it is */
    uint32_t behind;      /* pct: so many nodes have a higher priority */
};

/* The draws of all nodes, malloc'd. */
struct draw_node *draw_nodes(const struct draw *d, uint32_t nodes);
/* By how many parts per million the node computes slower; how much later its program starts, its k-th message
 * leaves, its k-th handler becomes due. k counts from 0. */
uint32_t draw_speed(const struct draw_node *n);
vtime draw_start(const struct draw_node *n);
vtime draw_message(const struct draw_node *n, uint64_t k);
vtime draw_interrupt(const struct draw_node *n, uint64_t k);
#endif
