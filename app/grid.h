/* grid.h - the cuberille grid: which pixels are grid points, how many subcubes a layer has.
 *
 * Grid lines lie every `step` pixels, and on the last pixel, so that no part of the image is lost. The last
 * column (row) of subcubes is narrower when step does not divide the side: 512 pixels at step 4 give 128
 * subcubes, of which the last is 3 pixels wide. Layer j lies between slices j and j+1.
 */
#ifndef GRID_H
#define GRID_H

struct grid {
    int pixels_x, pixels_y, slices;
    int step;   /* pixels between grid lines */
    int nx, ny; /* subcubes in a row; rows of subcubes in a layer */
    int comps;  /* numbers at a grid point: 1 (C0 data) or 8 (C3 data) */
    double dz;  /* distance of two slices; pixels have distance 1 */
};

/* One subcube: its lower corner and widths in pixels. The corner's z is counted in slices, so that both
 * layers at a face compute the same z, to the bit. */
struct cell {
    double x, y, layer;
    double wx, wy, dz;
};

void grid_set(struct grid *g, int pixels_x, int pixels_y, int slices, int step, int comps, double dz);

/* Pixel of grid line i along a side of `pixels` pixels. */
int grid_line(int i, int pixels, int step);

/* Doubles of one row of grid points, and of all grid points of a slice. */
int grid_row_doubles(const struct grid *g);
int grid_slice_doubles(const struct grid *g);

/* Subcubes of one layer. */
int grid_cells(const struct grid *g);

struct cell grid_cell(const struct grid *g, int col, int row, int layer);

#endif
