/* channel_shapes.h - draws a channel map: a mesh as it lies, a hypercube as a table. */
#ifndef LAB_SHOW_CHANNEL_SHAPES_H
#define LAB_SHOW_CHANNEL_SHAPES_H
#include "lab/show/channel_map.h"

/* Height of the map, in points, with its axes and legend. */
double channel_shapes_height(const struct show *s);
/* Draws a bin's map below y. */
void channel_shapes_draw(const struct channel_map *m, const struct canvas *c, double y, uint32_t bin);
#endif
