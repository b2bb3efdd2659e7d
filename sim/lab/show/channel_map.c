/* channel_map.c - see channel_map.h. */
#include "lab/show/channel_map.h"
#include <math.h>
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "lab/draw/axes.h"

/* The scale ends no earlier: a network that is hardly used looks like that. */
static const double LEAST_END = 0.1;

bool *channel_map_shown(const struct show *s)
{
    const struct trace *t = s->trace;
    bool *shown = xcalloc(t->topo.addresses, sizeof *shown);
    for (const struct trace_message *m = t->messages; m < t->messages + t->message_count; m++) {
        shown[m->from_address] |= m->from_address >= t->topo.positions;
        shown[m->to_address] |= m->to_address >= t->topo.positions;
    }
    for (int32_t n = 0; n < t->node_count; n++)
        shown[t->nodes[n].address] |= s->rows.row[n] != TRACE_NONE;
    return shown;
}

struct channel_map channel_map_make(const struct show *s, struct time_bins bins)
{
    struct channel_map m = {s, channel_use_make(s->trace, bins), heat_linear(0), channel_map_shown(s)};
    double most = 0;
    for (uint32_t bin = 0; bin < bins.count; bin++)
        for (uint32_t c = 0; c < m.use.channels; c++)
            most = fmax(most, channel_use_share(&m.use, bin, c));
    m.heat = s->most_share > 0 ? heat_given(s->most_share, false) : heat_linear(fmax(most, LEAST_END));
    return m;
}

void channel_map_free(struct channel_map *m)
{
    channel_use_free(&m->use);
    free(m->shown);
}

/* Are there messages that the trace, or what was selected of it, does not have? */
static bool lacks_messages(const struct trace *t)
{
    for (int32_t n = 0; n < t->node_count; n++)
        if (!t->nodes[n].traced)
            return true;
    return false;
}

static char *shape_text(const struct topo *topo)
{
    if (topo->rows)
        return xasprintf("mesh of %u row%s of %u", topo->rows, topo->rows == 1 ? "" : "s", topo->columns);
    return xasprintf("hypercube of %u dimension%s", topo->dimension, topo->dimension == 1 ? "" : "s");
}

char *channel_map_notes(const struct channel_map *m)
{
    const struct trace *t = m->show->trace;
    char name[80];
    double share;
    uint32_t busiest = channel_use_busiest(&m->use, &share);
    char *shape = shape_text(&t->topo), *percent = axis_percent_text(share), *text;
    trace_channel_name(t, busiest, name, sizeof name);
    const char *only = lacks_messages(t) ? "; messages of these nodes only" : "";
    text = share > 0
               ? xasprintf("%s; the busiest channel: %s, held %s of the time%s", shape, name, percent, only)
               : xasprintf("%s; no channel was held%s", shape, only);
    free(percent);
    free(shape);
    return text;
}
