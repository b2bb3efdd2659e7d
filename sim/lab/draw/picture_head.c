/* picture_head.c - see picture_head.h. */
#include "lab/draw/picture_head.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "lab/draw/axes.h"

/* The program, on which machine, with how many nodes, when. malloc'd. */
static char *subject(const struct show *s)
{
    const struct trace *t = s->trace;
    const char *program = basename(t->program);
    vtime resolution = (t->to - t->from) / 1000;
    char *from = axis_time_text(t->from, resolution), *to = axis_time_text(vt_min(t->to, t->end), resolution);
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
    char *what = subject(s), *head = s->label ? xasprintf("%s: %s", title, s->label) : xstrdup(title);
    *notes = (char)toupper((unsigned char)*notes);
    canvas_text(c, HEAD_LEFT, 30, (struct text_style){17, INK, ANCHOR_LEFT, true}, head);
    canvas_text(c, HEAD_LEFT, 48, (struct text_style){11.5, INK, ANCHOR_LEFT, false}, what);
    canvas_text(c, HEAD_LEFT, 64, (struct text_style){10.5, GREY, ANCHOR_LEFT, false}, notes);
    free(head);
    free(what);
    free(notes);
}

double show_row_height(int32_t rows, double all, double least, double most)
{
    double height = all / rows;
    return height < least ? least : height > most ? most : height;
}
