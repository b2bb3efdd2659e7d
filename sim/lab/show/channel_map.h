/* channel_map.h - the network with its channels coloured by the share of time in which a message held them. A mesh is
 * drawn as it lies; a hypercube as a table, a row a node, a column a dimension. */
#ifndef LAB_SHOW_CHANNEL_MAP_H
#define LAB_SHOW_CHANNEL_MAP_H
#include "lab/show/channel_use.h"
#include "lab/show/displays.h"
#include "lab/show/heat.h"

struct channel_map {
    const struct show *show;
    struct channel_use use;
    struct heat heat; /* one scale for all bins */
    bool *shown;      /* channel_map_shown() */
};

struct channel_map channel_map_make(const struct show *s, struct time_bins bins);
void channel_map_free(struct channel_map *m);
/* Height of the map, in points, with its axes and legend. */
double channel_map_height(const struct show *s);
/* Draws a bin's map below y. */
void channel_map_draw(const struct channel_map *m, const struct canvas *c, double y, uint32_t bin);
/* What the notes say of it: how the map is to be read, and the busiest channel. malloc'd. */
char *channel_map_notes(const struct channel_map *m);

/* By address, malloc'd: the nodes in the picture, and those I/O nodes, or the host, that messages came from or went
 * to. */
bool *channel_map_shown(const struct show *s);

/* The parts, for a shape each: channel_cube.c, channel_mesh.c. */
double channel_cube_height(const struct show *s);
void channel_cube_draw(const struct channel_map *m, const struct canvas *c, double y, uint32_t bin);
double channel_mesh_height(const struct show *s);
void channel_mesh_draw(const struct channel_map *m, const struct canvas *c, double y, uint32_t bin);
#endif
