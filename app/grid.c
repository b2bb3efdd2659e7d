/* grid.c - the cuberille grid; see grid.h. */
#include "grid.h"

static int subcubes(int pixels, int step)
{
    return (pixels - 1 + step - 1) / step;
}

void grid_set(struct grid *g, int pixels_x, int pixels_y, int slices, int step, int comps, double dz)
{
    g->pixels_x = pixels_x;
    g->pixels_y = pixels_y;
    g->slices = slices;
    g->step = step;
    g->nx = subcubes(pixels_x, step);
    g->ny = subcubes(pixels_y, step);
    g->comps = comps;
    g->dz = dz;
}

int grid_line(int i, int pixels, int step)
{
    int p = i * step;

    return p < pixels - 1 ? p : pixels - 1;
}

int grid_row_doubles(const struct grid *g)
{
    return (g->nx + 1) * g->comps;
}

int grid_slice_doubles(const struct grid *g)
{
    return (g->ny + 1) * grid_row_doubles(g);
}

int grid_cells(const struct grid *g)
{
    return g->nx * g->ny;
}

struct cell grid_cell(const struct grid *g, int col, int row, int layer)
{
    struct cell c;
    int x0 = grid_line(col, g->pixels_x, g->step), x1 = grid_line(col + 1, g->pixels_x, g->step);
    int y0 = grid_line(row, g->pixels_y, g->step), y1 = grid_line(row + 1, g->pixels_y, g->step);

    c.x = x0;
    c.y = y0;
    c.layer = layer;
    c.wx = x1 - x0;
    c.wy = y1 - y0;
    c.dz = g->dz;
    return c;
}
