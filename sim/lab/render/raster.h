/* raster.h - the samples of a picture that a triangle covers.
 *
 * Corners are in fixed point, so that "covers" is exact: triangles that share an edge cover each sample
 * along that edge once, whatever their sizes: no holes, and no sample twice, which a transparent surface
 * would show. */
#ifndef LAB_RENDER_RASTER_H
#define LAB_RENDER_RASTER_H
#include <stdbool.h>
#include <stdint.h>

enum { RASTER_ONE = 256 }; /* fixed point: so many units a sample; sample (i, j) is at i + 1/2, j + 1/2 */

/* A corner: x to the right and y down, less than 2^29 units away from 0; near = 1 / depth. */
struct raster_corner {
    int32_t x, y;
    float near;
};

/* A window of samples: x from left to right - 1, y from top to bottom - 1. */
struct raster_window {
    int32_t left, top, right, bottom;
};

/* An edge from a to b; at a sample: more than 0 inside, 0 on it. */
struct raster_edge {
    int64_t at_origin, step_x, step_y; /* per sample */
    bool owns;                         /* the triangle has the samples on this edge */
};

static inline struct raster_edge raster_edge(const struct raster_corner *a, const struct raster_corner *b)
{
    int64_t dx = (int64_t)b->x - a->x, dy = (int64_t)b->y - a->y;
    const int64_t half = RASTER_ONE / 2;
    return (struct raster_edge){.at_origin = dx * (half - a->y) - dy * (half - a->x),
                                .step_x = -dy * RASTER_ONE,
                                .step_y = dx * RASTER_ONE,
                                .owns = dy < 0 || (dy == 0 && dx > 0)};
}

/* Twice the area in units of fixed point; less than 0: the other way round. */
static inline int64_t raster_area(const struct raster_corner *a, const struct raster_corner *b,
                                  const struct raster_corner *c)
{
    return ((int64_t)b->x - a->x) * ((int64_t)c->y - a->y) - ((int64_t)b->y - a->y) * ((int64_t)c->x - a->x);
}

static inline int32_t raster_least(int32_t a, int32_t b, int32_t c)
{
    int32_t least = a < b ? a : b;
    return least < c ? least : c;
}

static inline int32_t raster_most(int32_t a, int32_t b, int32_t c)
{
    return -raster_least(-a, -b, -c);
}

/* The part of the window that a triangle's box covers. */
static inline struct raster_window raster_box(const struct raster_corner t[3], struct raster_window w)
{
    struct raster_window box = {raster_least(t[0].x, t[1].x, t[2].x) / RASTER_ONE - 1,
                                raster_least(t[0].y, t[1].y, t[2].y) / RASTER_ONE - 1,
                                raster_most(t[0].x, t[1].x, t[2].x) / RASTER_ONE + 2,
                                raster_most(t[0].y, t[1].y, t[2].y) / RASTER_ONE + 2};
    box.left = box.left > w.left ? box.left : w.left;
    box.top = box.top > w.top ? box.top : w.top;
    box.right = box.right < w.right ? box.right : w.right;
    box.bottom = box.bottom < w.bottom ? box.bottom : w.bottom;
    return box;
}

/* Where a sample is in a triangle: the corners' weights in space (not in the picture), whose sum is 1. */
static inline void raster_weights(const struct raster_corner t[3], int32_t x, int32_t y, float weight[3])
{
    float sum = 0;
    for (int i = 0; i < 3; i++) {
        struct raster_edge e = raster_edge(&t[(i + 1) % 3], &t[(i + 2) % 3]);
        weight[i] = (float)(e.at_origin + x * e.step_x + y * e.step_y) * t[i].near;
        sum += weight[i];
    }
    for (int i = 0; i < 3; i++)
        weight[i] = sum != 0 ? weight[i] / sum : 1.0f / 3;
}

/* Calls hit(to, x, y, near) for each sample of the window that the triangle covers. Inlined with hit. */
static inline void raster_triangle(const struct raster_corner given[3], struct raster_window window,
                                   void (*hit)(void *to, int32_t x, int32_t y, float near), void *to)
{
    int64_t area = raster_area(&given[0], &given[1], &given[2]);
    if (area == 0)
        return;
    struct raster_corner t[3] = {given[0], given[area > 0 ? 1 : 2], given[area > 0 ? 2 : 1]};
    struct raster_window box = raster_box(t, window);
    struct raster_edge e[3];
    int64_t row[3];
    double near = 0, near_x = 0, near_y = 0, size = (double)(area > 0 ? area : -area);
    for (int i = 0; i < 3; i++) {
        e[i] = raster_edge(&t[(i + 1) % 3], &t[(i + 2) % 3]);
        near += (double)e[i].at_origin / size * (double)t[i].near;
        near_x += (double)e[i].step_x / size * (double)t[i].near;
        near_y += (double)e[i].step_y / size * (double)t[i].near;
        row[i] = e[i].at_origin + box.left * e[i].step_x + box.top * e[i].step_y - !e[i].owns;
    }
    for (int32_t y = box.top; y < box.bottom; y++) {
        int64_t in[3] = {row[0], row[1], row[2]};
        for (int32_t x = box.left; x < box.right; x++) {
            if ((in[0] | in[1] | in[2]) >= 0)
                hit(to, x, y, (float)(near + x * near_x + y * near_y));
            for (int i = 0; i < 3; i++)
                in[i] += e[i].step_x;
        }
        for (int i = 0; i < 3; i++)
            row[i] += e[i].step_y;
    }
}
#endif
