/* channel_mesh.h - draws the channel map of a mesh, as it lies. See channel_shapes.h. */
#ifndef LAB_SHOW_CHANNEL_MESH_H
#define LAB_SHOW_CHANNEL_MESH_H
#include "lab/show/channel_map.h"

double channel_mesh_height(const struct show *s);
void channel_mesh_draw(const struct channel_map *m, const struct canvas *c, double y, uint32_t bin);
#endif
