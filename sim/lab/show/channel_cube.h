/* channel_cube.h - draws the channel map of a hypercube, a row a node, a column a dimension. See
 * channel_shapes.h. */
#ifndef LAB_SHOW_CHANNEL_CUBE_H
#define LAB_SHOW_CHANNEL_CUBE_H
#include "lab/show/channel_map.h"

double channel_cube_height(const struct show *s);
void channel_cube_draw(const struct channel_map *m, const struct canvas *c, double y, uint32_t bin);
#endif
