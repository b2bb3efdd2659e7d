/* displays.c - see displays.h. */
#include "lab/show/displays.h"
#include <string.h>
#include "lab/show/display_parts.h"

const struct display DISPLAYS[] = {
    {"utilisation", "How many nodes compute, are in the system, or wait, over time.",
     "Look for times in which few compute: what do the others wait for?", utilisation_height,
     utilisation_draw, true, false},
    {"gantt", "What each node does, over time: a row a node, a colour an activity.",
     "Look for the node that computes while the others wait, and for waits that all have at one time.",
     gantt_height, gantt_draw, true, false},
    {"space-time", "A line a node, and a line from sender to receiver for each message.",
     "Look for chains of messages, each sent when another came: they follow the program's critical path.",
     space_time_height, space_time_draw, true, false},
    {"matrix", "How many messages (or bytes, with --by bytes) each node sent to each.",
     "Look for full rows and columns (a node that serves all), and for far neighbours (a poor mapping).",
     matrix_height, matrix_draw, false, false},
    {"lengths", "How many messages have which length, and how many bytes these carry.",
     "Look for many short ones, whose cost is the start-up time: can they be sent as one?", lengths_height,
     lengths_draw, false, false},
    {"queues", "How many messages wait at each node that its program has not taken, over time.",
     "Look for a node whose queue grows: it receives more slowly than the others send.", queues_height,
     queues_draw, false, false},
    {"channels", "Which share of the time each channel of the network was held by a message.",
     "Look for a few dark channels among light ones: messages wait there.", channels_height, channels_draw,
     false, false},
    {"film", "The use of channels over time: an animated WebP, an interval of time a picture.",
     "Look for waves: phases in which the whole network works, or only the channels to one node.",
     channels_height, NULL, false, true},
    {"kiviat", "How busy each node was: a spoke a node, the farther from the centre the busier.",
     "Look for a shape that is not round: the load is not balanced.", kiviat_height, kiviat_draw, false,
     false},
    {0}};

const struct display *display_find(const char *name)
{
    for (const struct display *d = DISPLAYS; d->name; d++)
        if (!strcmp(d->name, name))
            return d;
    return NULL;
}
