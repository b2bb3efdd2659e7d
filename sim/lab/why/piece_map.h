/* piece_map.h - what a node did at a time: the pieces (trace_model.h) of all nodes, found by time.
 *
 * The pieces of a node are made when the node is first asked for, and kept until piece_map_free(). */
#ifndef LAB_WHY_PIECE_MAP_H
#define LAB_WHY_PIECE_MAP_H
#include "lab/trace/trace_model.h"

struct piece_map {
    const struct trace *t;
    struct trace_pieces *of; /* by node; none yet: list is NULL */
};

/* The trace must outlive the map. */
struct piece_map piece_map_new(const struct trace *t);
void piece_map_free(struct piece_map *m);

/* All pieces of a node, in order of time. */
const struct trace_pieces *piece_map_of(struct piece_map *m, int32_t node);
/* The piece of a node that `t` ends or lies in: begin < t <= end. NULL: none, t is not in the trace. */
const struct trace_piece *piece_map_before(struct piece_map *m, int32_t node, vtime t);
/* The first piece of a node that ends after t; NULL: none. The others follow, up to piece_map_end(). */
const struct trace_piece *piece_map_from(struct piece_map *m, int32_t node, vtime t);
const struct trace_piece *piece_map_end(struct piece_map *m, int32_t node);

/* Does the system enter a handler in the piece, or leave one? */
static inline bool piece_enters_handler(const struct trace_piece *p)
{
    return p->state == TRACE_IN_SYSTEM && p->in_handler && p->system == TRACE_NONE;
}

/* The wait of the piece's call that `t`, which is in the piece or its end, ends or lies in: begin < t <= end;
 * TRACE_NONE. */
int32_t piece_map_wait(const struct piece_map *m, const struct trace_piece *p, vtime t);
/* A handler of a node that begins at t; TRACE_NONE. */
int32_t piece_map_handler(const struct piece_map *m, int32_t node, vtime t);
/* The interval in which a node's system did that task, that `t` ends or lies in; TRACE_NONE. */
int32_t piece_map_system(const struct piece_map *m, int32_t node, enum trace_task task, vtime t);
#endif
