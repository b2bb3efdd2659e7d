/* deadlock_edges.h - the edges of a wait-for graph, drawn as curves between boxes. */
#ifndef LAB_DEADLOCK_DEADLOCK_EDGES_H
#define LAB_DEADLOCK_DEADLOCK_EDGES_H
#include "lab/deadlock/deadlock_layout.h"

void deadlock_edge_draw(const struct canvas *c, const struct deadlock_layout *l,
                        const struct deadlock_edge *e);

/* Where labels lie already. */
struct deadlock_labels {
    struct plot *taken; /* the caller frees it */
    uint32_t count;
};

/* Puts a label of the graph's edge e on its curve: where it hides neither a box nor another label, if there
 * is such a place. When all edges have been drawn. */
void deadlock_edge_label(const struct canvas *c, const struct deadlock_graph *g,
                         const struct deadlock_layout *l, const struct deadlock_edge *e, const char *text,
                         struct deadlock_labels *labels);
#endif
