/* slice.h - the test volume: a sphere whose gray level rises with the radius. */
#ifndef SLICE_H
#define SLICE_H
#include "grid.h"

typedef unsigned short pixel; /* a gray level, 0 to 65535 */

/* Make slice k: the level of each pixel is proportional to the pixel's distance from the centre of the
 * volume, and 65535 in the volume's corners. */
void slice_sphere(const struct grid *g, int k, pixel *image);

/* Gray level at `radius` pixels from the centre. */
double slice_level(const struct grid *g, double radius);

#endif
