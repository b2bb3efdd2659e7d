/* deadlock_graph.h - the wait-for graph as people can see it: boxes for nodes, and edges between them.
 *
 * Few nodes have a box each. Of many, nodes that do the same, wait for the same and have the same cause share
 * one. A long cycle keeps its first and last nodes; those between them share a box. So no graph has more than
 * DEADLOCK_MOST_BOXES. */
#ifndef LAB_DEADLOCK_DEADLOCK_GRAPH_H
#define LAB_DEADLOCK_DEADLOCK_GRAPH_H
#include "nx_api/waitfor/waitfor.h"

enum { DEADLOCK_MOST_ALONE = 8, DEADLOCK_MOST_CYCLE = 10, DEADLOCK_MOST_BOXES = 22 };

struct deadlock_box {
    const struct waitfor_node *like; /* the first of its nodes; what they share */
    uint32_t *nodes, count;          /* indices, ascending */
    bool in_cycle;
    bool mixed; /* nodes in several states: those for which no box was left */
};

struct deadlock_edge {
    uint32_t from, to;     /* boxes; the same: nodes of one box wait for others of it */
    enum waitfor_who kind; /* one: only this; any: one of several; all: each of several */
    bool in_cycle;
};

struct deadlock_graph {
    const struct waitfor *w;
    struct deadlock_box *boxes; /* those of the cycle first, in its order; then the largest first */
    uint32_t count, cycle_count;
    struct deadlock_edge *edges;
    uint32_t edge_count;
};

/* Of an analysed w, which must outlive the graph. */
struct deadlock_graph *deadlock_graph_make(const struct waitfor *w);
void deadlock_graph_free(struct deadlock_graph *g);
#endif
