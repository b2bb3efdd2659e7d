/* displays.c - see displays.h. */
#include "lab/show/displays.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "lab/show/axes.h"
#include "lab/show/display_parts.h"

const struct display DISPLAYS[] = {
    {"utilisation", "Utilisation count", "How many nodes compute, are in the system, or wait, over time.",
     "Look for times in which few compute: what do the others wait for?", utilisation_height,
     utilisation_draw, false},
    {"gantt", "Gantt chart", "What each node does, over time: a row a node, a colour an activity.",
     "Look for the node that computes while the others wait, and for waits that all have at one time.",
     gantt_height, gantt_draw, false},
    {"space-time", "Space-time diagram",
     "A line a node, and a line from sender to receiver for each message.",
     "Look for chains of messages, each sent when another came: they follow the program's critical path.",
     space_time_height, space_time_draw, false},
    {"matrix", "Communication matrix",
     "How many messages (or bytes, with --by bytes) each node sent to each.",
     "Look for full rows and columns (a node that serves all), and for far neighbours (a poor mapping).",
     matrix_height, matrix_draw, false},
    {"lengths", "Message lengths", "How many messages have which length, and how many bytes these carry.",
     "Look for many short ones, whose cost is the start-up time: can they be sent as one?", lengths_height,
     lengths_draw, false},
    {"queues", "Message queues",
     "How many messages wait at each node that its program has not taken, over time.",
     "Look for a node whose queue grows: it receives more slowly than the others send.", queues_height,
     queues_draw, false},
    {"channels", "Use of channels",
     "Which share of the time each channel of the network was held by a message.",
     "Look for a few dark channels among light ones: messages wait there.", channels_height, channels_draw,
     false},
    {"film", "Use of channels, as a film",
     "The use of channels over time: an animated WebP, an interval of time a picture.",
     "Look for waves: phases in which the whole network works, or only the channels to one node.",
     channels_height, NULL, true},
    {"kiviat", "Kiviat diagram",
     "How busy each node was: a spoke a node, the farther from the centre the busier.",
     "Look for a shape that is not round: the load is not balanced.", kiviat_height, kiviat_draw, false},
    {0}};

const struct display *display_find(const char *name)
{
    for (const struct display *d = DISPLAYS; d->name; d++)
        if (!strcmp(d->name, name))
            return d;
    return NULL;
}

/* The program, on which machine, with how many nodes, when. malloc'd. */
static char *subject(const struct show *s)
{
    const struct trace *t = s->trace;
    const char *slash = strrchr(t->program, '/'), *program = slash ? slash + 1 : t->program;
    vtime resolution = (t->to - t->from) / 1000;
    char *from = axis_time_text(t->from, resolution), *to = axis_time_text(t->to, resolution);
    int32_t all = t->node_count - t->topo.host, nodes = s->rows.nodes - s->rows.host;
    char *count = nodes == all ? xasprintf("%d node%s", all, all == 1 ? "" : "s")
                               : xasprintf("%d of %d nodes", nodes, all);
    char *text = xasprintf("%s on %s \u00b7 %s%s \u00b7 %s to %s%s", program, t->machine, count,
                           s->rows.host ? " and the host" : "", from, to,
                           t->complete ? "" : " \u00b7 the trace ends early");
    free(count);
    free(from);
    free(to);
    return text;
}

void show_head(const struct show *s, const struct canvas *c, const char *title, char *notes)
{
    char *what = subject(s);
    *notes = (char)toupper((unsigned char)*notes);
    canvas_text(c, 24, 30, (struct text_style){17, INK, ANCHOR_LEFT, true}, title);
    canvas_text(c, 24, 48, (struct text_style){11.5, INK, ANCHOR_LEFT, false}, what);
    canvas_text(c, 24, 64, (struct text_style){10.5, GREY, ANCHOR_LEFT, false}, notes);
    free(what);
    free(notes);
}

double show_row_height(int32_t rows, double all, double least, double most)
{
    double height = all / rows;
    return height < least ? least : height > most ? most : height;
}
