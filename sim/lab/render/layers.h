/* layers.h - what is seen at each sample of a band: the nearest opaque triangle, and all transparent ones
 * before it, from the nearest on.
 *
 *   sample   opaque: near, triangle        the z-buffer
 *            transparent ----> layer ----> layer ----> ...      nearest first
 *
 * Samples are numbered row by row. Where two triangles are equally near, the one of the lower number is
 * first. */
#ifndef LAB_RENDER_LAYERS_H
#define LAB_RENDER_LAYERS_H
#include <stddef.h>
#include <stdint.h>
#include "lab/render/raster.h"

enum { LAYERS_NONE = UINT32_MAX };

struct layer {
    float near;
    uint32_t triangle, next; /* next: an index of pool; LAYERS_NONE: the last */
};

struct layers {
    struct raster_window window;
    size_t samples;
    struct layer *opaque; /* of each sample; triangle LAYERS_NONE: none; next: its first transparent one */
    struct layer *pool;
    size_t used, room;
};

struct layers *layers_new(struct raster_window window);
void layers_free(struct layers *l);

/* Empties the layers; they now belong to the window of the same size from that row on. */
void layers_clear(struct layers *l, int32_t top);

/* Add a triangle. All opaque ones come before the first transparent one. */
void layers_opaque(struct layers *l, const struct raster_corner corner[3], uint32_t triangle);
void layers_transparent(struct layers *l, const struct raster_corner corner[3], uint32_t triangle);
#endif
