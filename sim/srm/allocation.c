/* allocation.c - see allocation.h. */
#include "srm/allocation.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "net/topo.h"

void allocation_open(struct allocation *s, const struct cfg_machine *m)
{
    s->cube = m->topology == CFG_HYPERCUBE;
    s->rows = s->cube ? 1 : m->rows;
    s->columns = s->cube ? UINT32_C(1) << m->dimension : m->columns;
    s->holder = xcalloc(allocation_all(s), 1);
}

void allocation_close(struct allocation *s)
{
    free(s->holder);
}

uint32_t allocation_all(const struct allocation *s)
{
    return s->rows * s->columns;
}

uint32_t allocation_free(const struct allocation *s)
{
    uint32_t n = 0;
    for (uint32_t i = 0; i < allocation_all(s); i++)
        n += s->holder[i] == 0;
    return n;
}

static bool is_free(const struct allocation *s, const struct allocation_piece *p)
{
    for (uint32_t r = p->row; r < p->row + p->rows; r++)
        for (uint32_t c = p->column; c < p->column + p->columns; c++)
            if (s->holder[r * s->columns + c])
                return false;
    return true;
}

/* --- hypercube --- */

static bool subcube_is_free(const struct allocation *s, uint32_t first, uint32_t nodes)
{
    return first + nodes <= s->columns && is_free(s, &(struct allocation_piece){nodes, 0, first, 1, nodes});
}

/* Finds the first free aligned subcube of so many nodes that is no half of a larger free one. */
static bool find_subcube(const struct allocation *s, uint32_t nodes, uint32_t *first)
{
    for (*first = 0; *first < s->columns; *first += nodes)
        if (subcube_is_free(s, *first, nodes) && !subcube_is_free(s, *first & ~nodes, 2 * nodes))
            return true;
    return false;
}

static bool place_cube(const struct allocation *s, struct allocation_piece *p)
{
    p->rows = 1, p->columns = p->nodes;
    for (uint32_t nodes = p->nodes; nodes <= s->columns; nodes *= 2)
        if (find_subcube(s, nodes, &p->column))
            return true;
    return false;
}

/* --- mesh --- */

/* Finds the first position, row by row, at which a rectangle is free. */
static bool place_rectangle(const struct allocation *s, struct allocation_piece *p)
{
    for (p->row = 0; p->row + p->rows <= s->rows; p->row++)
        for (p->column = 0; p->column + p->columns <= s->columns; p->column++)
            if (is_free(s, p))
                return true;
    return false;
}

static bool shape(const struct allocation *s, const struct cube_type *t, struct allocation_piece *p)
{
    struct topo topo;
    p->nodes = t->nodes;
    if (s->cube)
        return t->nodes <= s->columns;
    p->rows = t->rows, p->columns = t->columns;
    if (!t->rows && topo_mesh(&topo, t->nodes, s->rows, s->columns))
        p->rows = topo.rows, p->columns = topo.columns;
    return p->rows > 0 && p->rows <= s->rows && p->columns <= s->columns;
}

/* --- both --- */

bool allocation_possible(const struct allocation *s, const struct cube_type *type)
{
    struct allocation_piece p = {0};
    return shape(s, type, &p);
}

bool allocation_take(struct allocation *s, const struct cube_type *type, uint8_t holder,
                     struct allocation_piece *piece)
{
    struct allocation_piece p = {0};
    if (!shape(s, type, &p) || !(s->cube ? place_cube(s, &p) : place_rectangle(s, &p)))
        return false;
    for (uint32_t r = p.row; r < p.row + p.rows; r++)
        memset(&s->holder[r * s->columns + p.column], holder, p.columns);
    *piece = p;
    return true;
}

void allocation_give_back(struct allocation *s, uint8_t holder)
{
    for (uint32_t i = 0; i < allocation_all(s); i++)
        if (s->holder[i] == holder)
            s->holder[i] = 0;
}

static uint32_t largest_cube(const struct allocation *s)
{
    struct allocation_piece p = {.nodes = s->columns};
    while (p.nodes && !place_cube(s, &p))
        p.nodes /= 2;
    return p.nodes;
}

/* Row by row, columns as heights of free nodes above: the largest rectangle that ends in this row. */
static uint32_t largest_rectangle(const struct allocation *s)
{
    uint32_t *height = xcalloc(s->columns, sizeof *height), most = 0;
    for (uint32_t r = 0; r < s->rows; r++) {
        for (uint32_t c = 0; c < s->columns; c++)
            height[c] = s->holder[r * s->columns + c] ? 0 : height[c] + 1;
        for (uint32_t c = 0; c < s->columns; c++) {
            uint32_t low = height[c];
            for (uint32_t e = c; e < s->columns && low; e++) {
                low = height[e] < low ? height[e] : low;
                most = low * (e - c + 1) > most ? low * (e - c + 1) : most;
            }
        }
    }
    free(height);
    return most;
}

uint32_t allocation_largest(const struct allocation *s)
{
    return s->cube ? largest_cube(s) : largest_rectangle(s);
}
