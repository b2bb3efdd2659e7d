/* c3.c - C0 and C3 data of the grid points by finite differences.
 *
 * A derivative along one axis is the difference of the two neighbouring pixels over their distance. The
 * distance is 2 inside the volume, and 1 at its edge, where the pixel itself replaces the missing neighbour.
 * A mixed derivative is the product of such differences; all 27 pixels around a point take part. Mixed
 * derivatives are exact for polynomials that are at most quadratic in each variable inside, and linear at the
 * edge. The paper's text counts 27 pixels, too; its printed formulas for mixed derivatives take two opposite
 * pixels, and would find a mixed derivative of 1 in F = x + y.
 */
#include <stddef.h>
#include "c3.h"

/* The two neighbours along one axis and 1 / their distance. */
struct pair {
    int lo, hi;
    double inv;
};

static struct pair neighbours(int i, int n)
{
    struct pair p;

    p.lo = i > 0 ? i - 1 : i;
    p.hi = i < n - 1 ? i + 1 : i;
    p.inv = 1.0 / (p.hi - p.lo);
    return p;
}

/* The level and its differences within one slice. */
struct plane {
    double f, fx, fy, fxy;
};

static struct plane differences(const pixel *image, int width, int x, int y, struct pair px, struct pair py)
{
    const pixel *lo = image + (long)py.lo * width, *at = image + (long)y * width,
                *hi = image + (long)py.hi * width;
    struct plane d;

    d.f = at[x];
    d.fx = (at[px.hi] - at[px.lo]) * px.inv;
    d.fy = (hi[x] - lo[x]) * py.inv;
    d.fxy = (hi[px.hi] - hi[px.lo] - lo[px.hi] + lo[px.lo]) * px.inv * py.inv;
    return d;
}

void c0_slice(const struct grid *g, const pixel *image, double *out)
{
    int i, j;

    for (j = 0; j <= g->ny; j++) {
        const pixel *row = image + (long)grid_line(j, g->pixels_y, g->step) * g->pixels_x;

        for (i = 0; i <= g->nx; i++)
            *out++ = row[grid_line(i, g->pixels_x, g->step)];
    }
}

void c3_slice(const struct grid *g, const pixel *below, const pixel *image, const pixel *above, double *out)
{
    const pixel *lower = below ? below : image, *upper = above ? above : image;
    double inv = 1.0 / (((below != NULL) + (above != NULL)) * g->dz);
    int i, j;

    for (j = 0; j <= g->ny; j++) {
        int y = grid_line(j, g->pixels_y, g->step);
        struct pair py = neighbours(y, g->pixels_y);

        for (i = 0; i <= g->nx; i++, out += C3_COMPS) {
            int x = grid_line(i, g->pixels_x, g->step);
            struct pair px = neighbours(x, g->pixels_x);
            struct plane lo = differences(lower, g->pixels_x, x, y, px, py);
            struct plane at = differences(image, g->pixels_x, x, y, px, py);
            struct plane hi = differences(upper, g->pixels_x, x, y, px, py);

            out[F] = at.f;
            out[F_X] = at.fx;
            out[F_Y] = at.fy;
            out[F_Z] = (hi.f - lo.f) * inv;
            out[F_XY] = at.fxy;
            out[F_YZ] = (hi.fy - lo.fy) * inv;
            out[F_XZ] = (hi.fx - lo.fx) * inv;
            out[F_XYZ] = (hi.fxy - lo.fxy) * inv;
        }
    }
}
