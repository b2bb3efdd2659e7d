/* deadlock_layout.h - the places of a wait-for graph's boxes: the cycle, or all if there is none and they
 * are few, on an ellipse in its order; the others in rows below. Lengths are points (lab/draw/canvas.h). */
#ifndef LAB_DEADLOCK_DEADLOCK_LAYOUT_H
#define LAB_DEADLOCK_DEADLOCK_LAYOUT_H
#include "lab/deadlock/deadlock_graph.h"
#include "lab/draw/canvas.h"

enum { DEADLOCK_BOX_WIDTH = 196, DEADLOCK_BOX_HEIGHT = 58, DEADLOCK_HEAD = 84, DEADLOCK_FOOT = 44 };

struct deadlock_layout {
    struct plot *places; /* of each box */
    double height;       /* of the whole picture */
};

/* The caller frees places. */
struct deadlock_layout deadlock_layout_make(const struct deadlock_graph *g);
#endif
