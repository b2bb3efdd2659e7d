/* slice.c - generates the slices of a sphere with gray level increasing with the sphere's radius. */
#include <math.h>
#include "slice.h"

static void centre(const struct grid *g, double c[3])
{
    c[0] = (g->pixels_x - 1) / 2.0;
    c[1] = (g->pixels_y - 1) / 2.0;
    c[2] = (g->slices - 1) / 2.0 * g->dz;
}

static inline double distance(const double p[3], const double q[3])
{
    double sum = 0;
    int i;

    for (i = 0; i < 3; i++)
        sum += (p[i] - q[i]) * (p[i] - q[i]);
    return sqrt(sum);
}

static double levels_per_pixel(const struct grid *g)
{
    static const double corner[3] = {0, 0, 0};
    double c[3];

    centre(g, c);
    return 65535.0 / distance(corner, c);
}

double slice_level(const struct grid *g, double radius)
{
    return levels_per_pixel(g) * radius;
}

void slice_sphere(const struct grid *g, int k, pixel *image)
{
    double scale = levels_per_pixel(g), c[3], p[3], level;
    int x, y;

    centre(g, c);
    p[2] = k * g->dz;
    for (y = 0; y < g->pixels_y; y++)
        for (x = 0; x < g->pixels_x; x++) {
            p[0] = x;
            p[1] = y;
            level = floor(scale * distance(p, c) + 0.5);
            *image++ = level < 65535 ? (pixel)level : 65535;
        }
}
