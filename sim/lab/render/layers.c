/* layers.c - see layers.h. */
#include "lab/render/layers.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

struct layers *layers_new(struct raster_window window)
{
    struct layers *l = xcalloc(1, sizeof *l);
    l->window = window;
    l->samples = (size_t)(window.right - window.left) * (size_t)(window.bottom - window.top);
    l->opaque = xreallocarray(NULL, l->samples, sizeof *l->opaque);
    layers_clear(l, window.top);
    return l;
}

void layers_free(struct layers *l)
{
    free(l->opaque);
    free(l->pool);
    free(l);
}

void layers_clear(struct layers *l, int32_t top)
{
    l->window.bottom += top - l->window.top;
    l->window.top = top;
    for (size_t i = 0; i < l->samples; i++)
        l->opaque[i] = (struct layer){0, LAYERS_NONE, LAYERS_NONE};
    l->used = 0;
}

struct one {
    struct layers *l;
    uint32_t triangle;
};

static inline struct layer *opaque_at(struct layers *l, int32_t x, int32_t y)
{
    return &l->opaque[(size_t)(y - l->window.top) * (size_t)(l->window.right - l->window.left) +
                      (size_t)(x - l->window.left)];
}

static inline void hit_opaque(void *to, int32_t x, int32_t y, float near)
{
    struct one *one = to;
    struct layer *at = opaque_at(one->l, x, y);
    if (near > at->near) {
        at->near = near;
        at->triangle = one->triangle;
    }
}

void layers_opaque(struct layers *l, const struct raster_corner corner[3], uint32_t triangle)
{
    struct one one = {l, triangle};
    raster_triangle(corner, l->window, hit_opaque, &one);
}

static inline void hit_transparent(void *to, int32_t x, int32_t y, float near)
{
    struct one *one = to;
    struct layers *l = one->l;
    struct layer *at = opaque_at(l, x, y);
    if (near <= at->near)
        return;
    if (l->used == l->room) {
        l->room = l->room ? 2 * l->room : 1 << 20;
        l->pool = xreallocarray(l->pool, l->room, sizeof *l->pool);
    }
    uint32_t *link = &at->next;
    while (*link != LAYERS_NONE && l->pool[*link].near >= near)
        link = &l->pool[*link].next;
    l->pool[l->used] = (struct layer){near, one->triangle, *link};
    *link = (uint32_t)l->used++;
}

void layers_transparent(struct layers *l, const struct raster_corner corner[3], uint32_t triangle)
{
    struct one one = {l, triangle};
    raster_triangle(corner, l->window, hit_transparent, &one);
}
