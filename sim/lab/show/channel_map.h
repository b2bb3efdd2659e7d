/* channel_map.h - the network with its channels coloured by the share of time in which a message held
 * them. A mesh is drawn as it lies; a hypercube as a table, a row a node, a column a dimension. */
#ifndef LAB_SHOW_CHANNEL_MAP_H
#define LAB_SHOW_CHANNEL_MAP_H
#include "lab/show/channel_use.h"
#include "lab/draw/picture_head.h"
#include "lab/draw/heat.h"

struct channel_map {
    const struct show *show;
    struct channel_use use;
    struct heat heat; /* one scale for all bins */
    bool *shown;      /* channel_map_shown() */
};

struct channel_map channel_map_make(const struct show *s, struct time_bins bins);
void channel_map_free(struct channel_map *m);
/* What the notes say of it: how the map is to be read, and the busiest channel. malloc'd. */
char *channel_map_notes(const struct channel_map *m);

/* By address, malloc'd: the nodes in the picture, and those I/O nodes, or the host, that messages came
 * from or went to. */
bool *channel_map_shown(const struct show *s);
#endif
