/* bands.c - see bands.h. */
#include "lab/render/bands.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

/* Calls visit for each triangle and each band that it may cover. */
static void each(const struct projection *p, int32_t rows, int32_t height,
                 void (*visit)(struct bands *b, size_t band, uint32_t triangle), struct bands *b)
{
    const struct raster_window picture = {INT32_MIN / 2, 0, INT32_MAX / 2, height};
    for (size_t s = 0; s < p->scene->count; s++)
        for (uint32_t t = p->first_triangle[s]; t < p->first_triangle[s + 1]; t++) {
            struct raster_corner corner[3];
            projection_corners(p, s, t, corner);
            struct raster_window box = raster_box(corner, picture);
            for (int32_t band = box.top / rows; box.top < box.bottom && band <= (box.bottom - 1) / rows;
                 band++)
                visit(b, (size_t)band, t);
        }
}

static void count(struct bands *b, size_t band, uint32_t triangle)
{
    (void)triangle;
    b->first[band + 2]++;
}

static void put(struct bands *b, size_t band, uint32_t triangle)
{
    b->triangle[b->first[band + 1]++] = triangle;
}

/* Counts into the entry after the next; sums make it each band's first; putting moves that to its end,
 * which is the next one's first. */
struct bands bands_make(const struct projection *p, int32_t rows, int32_t height)
{
    struct bands b = {.count = (size_t)((height + rows - 1) / rows)};
    b.first = xcalloc(b.count + 2, sizeof *b.first);
    each(p, rows, height, count, &b);
    for (size_t i = 2; i < b.count + 2; i++)
        b.first[i] += b.first[i - 1];
    b.triangle = xreallocarray(NULL, b.first[b.count + 1], sizeof *b.triangle);
    each(p, rows, height, put, &b);
    return b;
}

void bands_free(struct bands *b)
{
    free(b->first);
    free(b->triangle);
}
