/* app_kernels.c - the model program's numeric code as kernels of the counting benchmark; see kernels.c. */
#include <stddef.h>
#include "app/c3.h"
#include "app/fit.h"
#include "app/slice.h"
#include "app/subcube.h"
#include "kernels.h"

#define SIDE_PIXELS 65
#define SLICES 4

static struct grid grid;
static pixel image[SLICES][SIDE_PIXELS * SIDE_PIXELS];
static double data[SLICES][SIDE_PIXELS * SIDE_PIXELS * C3_COMPS];
static double sum;

static void prepare(int comps)
{
    static int made;
    grid_set(&grid, SIDE_PIXELS, SIDE_PIXELS, SLICES, 4, comps, 1.0);
    if (!made)
        for (int k = 0; k < SLICES; k++)
            slice_sphere(&grid, k, image[k]);
    made = 1;
    sum = 0;
}

static void prepare_data(int comps)
{
    prepare(comps);
    for (int k = 0; k < SLICES; k++)
        if (comps == 1)
            c0_slice(&grid, image[k], data[k]);
        else
            c3_slice(&grid, k ? image[k - 1] : NULL, image[k], k + 1 < SLICES ? image[k + 1] : NULL, data[k]);
}

static void take(int iso, int n, const vertex *v)
{
    sum += iso + n + v[0][0];
}

static void corners(int col, int row, int layer, const double *corner[8])
{
    for (int c = 0; c < 8; c++)
        corner[c] = data[layer + (c >> 2)] + (row + (c >> 1 & 1)) * grid_row_doubles(&grid) +
                    (col + (c & 1)) * grid.comps;
}

static const struct isovalues iso = {2, {20000.3, 40000.7}};

double KERNEL(app_slice)(void)
{
    prepare(1);
    for (int k = 0; k < SLICES; k++)
        slice_sphere(&grid, k, image[k]);
    return image[1][100];
}

double KERNEL(app_c3)(void)
{
    prepare(C3_COMPS);
    for (int n = 0; n < 20; n++)
        c3_slice(&grid, image[0], image[1], image[2], data[1]);
    return data[1][1000];
}

double KERNEL(app_fit)(void)
{
    static struct fit_system system;
    const double *corner[8], widths[3] = {4, 4, 1};
    double b[FIT_UNKNOWNS];
    prepare_data(C3_COMPS);
    for (int i = 0; i < 16; i++) {
        corners(i, i, 1, corner);
        fit_prepare(&system, widths);
        fit_tricubic(&system, corner, b);
        sum += b[21];
    }
    return sum;
}

double KERNEL(app_trilinear)(void)
{
    const double *corner[8];
    prepare_data(1);
    for (int row = 0; row < grid.ny; row++)
        for (int col = 0; col < grid.nx; col++) {
            struct cell cell = grid_cell(&grid, col, row, 1);
            corners(col, row, 1, corner);
            trilinear_polygons(&cell, corner, &iso, take);
        }
    return sum;
}

double KERNEL(app_tricubic)(void)
{
    static struct fit_system system; /* zeros: the first subcube sets it up */
    const double *corner[8];
    prepare_data(C3_COMPS);
    for (int i = 0; i < 16; i++) {
        struct cell cell = grid_cell(&grid, i, i / 2, 1);
        corners(i, i / 2, 1, corner);
        tricubic_polygons(&system, &cell, corner, &iso, 2, 8, take);
    }
    return sum;
}
