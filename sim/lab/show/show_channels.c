/* show_channels.c - the use of channels over the whole interval. */
#include "lab/show/channel_shapes.h"
#include "lab/show/display_parts.h"

double channels_height(const struct show *s)
{
    return HEAD_HEIGHT + channel_shapes_height(s) + 10;
}

void channels_draw(const struct show *s, const struct canvas *c)
{
    struct channel_map m = channel_map_make(s, time_bins_make(s->trace->from, s->trace->to, 1));
    show_head(s, c, "Use of channels", channel_map_notes(&m));
    channel_shapes_draw(&m, c, HEAD_HEIGHT, 0);
    channel_map_free(&m);
}
