/* layer.c - computing the subcubes between two slices; packing rows of them into messages. */
#include "layer.h"
#include "share.h"

/* Header of a chunk: kind, layer, first subcube, number of subcubes. */
enum { KIND, LAYER, FIRST, COUNT, HEADER };

static int is_prepared(enum prepare when, const struct fit_system *system, int nth)
{
    return when == PREPARE_ONCE ? system->widths[0] > 0 : when == PREPARE_CHUNK && nth > 0;
}

void layer_prepare(const struct options *o, struct fit_system *system, int nth)
{
    struct cell any;
    double widths[3];

    if (o->grid.comps == 1 || is_prepared(o->policy.prepare, system, nth))
        return;
    any = grid_cell(&o->grid, 0, 0, 0);
    widths[0] = any.wx;
    widths[1] = any.wy;
    widths[2] = any.dz;
    fit_prepare(system, widths);
}

void layer_cell(const struct options *o, struct fit_system *system, const struct layer *l, int cell,
                polygon_fn *out)
{
    const struct grid *g = &o->grid;
    int row = cell / g->nx, col = cell - row * g->nx, c;
    struct cell where = grid_cell(g, col, row, l->number);
    const double *corner[8];

    for (c = 0; c < 8; c++)
        corner[c] = (c & 4 ? l->upper : l->lower) + (row - l->row + (c >> 1 & 1)) * grid_row_doubles(g) +
                    (col + (c & 1)) * g->comps;
    if (g->comps == 1)
        trilinear_polygons(&where, corner, &o->iso, out);
    else
        tricubic_polygons(system, &where, corner, &o->iso, o->lattice, o->search, out);
}

long chunk_bytes_max(const struct options *o)
{
    const struct grid *g = &o->grid;
    long lines = pool_chunk_max(g->ny, g->nx, o->policy.k, o->policy.min_rows) / g->nx + 1;

    return (HEADER + 2 * lines * grid_row_doubles(g)) * (long)sizeof(double);
}

static double *pack_rows(double *to, const double *from, int n)
{
    while (n-- > 0)
        *to++ = *from++;
    return to;
}

long chunk_pack(const struct grid *g, const struct layer *l, int first, int count, double *message)
{
    int row = first / g->nx, rows = (first + count - 1) / g->nx - row + 1, wide = grid_row_doubles(g);
    double *end = message + HEADER;

    message[KIND] = CHUNK_WORK;
    message[LAYER] = l->number;
    message[FIRST] = first;
    message[COUNT] = count;
    end = pack_rows(end, l->lower + row * wide, (rows + 1) * wide);
    end = pack_rows(end, l->upper + row * wide, (rows + 1) * wide);
    return (end - message) * (long)sizeof(double);
}

long chunk_pack_word(enum chunk_kind kind, double *message)
{
    message[KIND] = kind;
    message[LAYER] = message[FIRST] = message[COUNT] = 0;
    return HEADER * (long)sizeof(double);
}

struct chunk chunk_unpack(const struct grid *g, const double *message)
{
    struct chunk c;
    int rows;

    c.kind = (enum chunk_kind)message[KIND];
    c.first = (int)message[FIRST];
    c.count = (int)message[COUNT];
    c.layer.number = (int)message[LAYER];
    c.layer.row = c.first / g->nx;
    rows = c.count > 0 ? (c.first + c.count - 1) / g->nx - c.layer.row + 1 : 0;
    c.layer.lower = message + HEADER;
    c.layer.upper = c.layer.lower + (rows + 1) * grid_row_doubles(g);
    return c;
}
