/* slice.c - generates the slices of a sphere with gray level increasing with the sphere's radius. */
#include <math.h>
#include "slice.h"

struct point {
    double x, y, z;
};

static struct point centre(const struct grid *g)
{
    struct point c;

    c.x = (g->pixels_x - 1) / 2.0;
    c.y = (g->pixels_y - 1) / 2.0;
    c.z = (g->slices - 1) / 2.0 * g->dz;
    return c;
}

static double distance(double dx, double dy, double dz)
{
    return sqrt(dx * dx + dy * dy + dz * dz);
}

static double levels_per_pixel(const struct grid *g)
{
    struct point c = centre(g);

    return 65535.0 / distance(c.x, c.y, c.z);
}

double slice_level(const struct grid *g, double radius)
{
    return levels_per_pixel(g) * radius;
}

void slice_sphere(const struct grid *g, int k, pixel *image)
{
    struct point c = centre(g);
    double scale = levels_per_pixel(g);
    int x, y;

    for (y = 0; y < g->pixels_y; y++)
        for (x = 0; x < g->pixels_x; x++)
            *image++ = (pixel)(scale * distance(x - c.x, y - c.y, k * g->dz - c.z) + 0.5);
}
