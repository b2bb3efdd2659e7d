/* allocation.h - the nodes of a machine, and which cube holds each: shared out as the System Resource Manager
 * did.
 *
 * Hypercube: aligned subcubes of 2^k nodes. As with buddies: the smallest free aligned subcube that is large
 * enough, of those the one with the lowest nodes, is halved until it fits; the lower half is taken. All
 * aligned subcubes of a size are alike: e-cube distances within a subcube, and so all virtual times, do not
 * depend on where it lies. Mesh: rectangles, first fit, row by row. A number of nodes gets the rectangle that
 * touchstone run gives it, never another of that size, in which distances would differ.
 */
#ifndef SRM_ALLOCATION_H
#define SRM_ALLOCATION_H
#include "config/cube_type.h"

struct allocation {
    bool cube;
    uint32_t rows, columns; /* of the machine; a hypercube is one row */
    uint8_t *holder;        /* of each node; 0: the node is free */
};

/* What a cube holds. */
struct allocation_piece {
    uint32_t nodes;                      /* of programs */
    uint32_t row, column, rows, columns; /* hypercube: one row; column is the first node */
};

void allocation_open(struct allocation *s, const struct cfg_machine *m);
void allocation_close(struct allocation *s);

/* Takes nodes for a holder, 1 to 255. Returns false if they are not free, or there are not so many. */
bool allocation_take(struct allocation *s, const struct cube_type *type, uint8_t holder,
                     struct allocation_piece *piece);
void allocation_give_back(struct allocation *s, uint8_t holder);

uint32_t allocation_all(const struct allocation *s);
uint32_t allocation_free(const struct allocation *s);
/* The nodes of the largest subcube, or of a mesh the largest rectangle, that could be taken now. */
uint32_t allocation_largest(const struct allocation *s);
/* Could the cube be taken if all nodes were free? */
bool allocation_possible(const struct allocation *s, const struct cube_type *type);
#endif
