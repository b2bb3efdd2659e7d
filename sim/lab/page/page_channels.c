/* page_channels.c - see page_channels.h. */
#include "lab/page/page_channels.h"
#include <stdlib.h>
#include "files/json_set.h"
#include "kernel/xalloc.h"

/* Adds [begin, end] to the channel's bins. */
static void add_to_bins(struct page_channels *c, uint32_t channel, vtime begin, vtime end)
{
    double from = (double)(begin - c->t->from) / c->bin, to = (double)(end - c->t->from) / c->bin;
    double *bins = &c->bins[(size_t)channel * PAGE_CHANNEL_BINS];
    for (int i = (int)from; i < PAGE_CHANNEL_BINS && i < to; i++) {
        double least = from > i ? from : i, most = to < i + 1 ? to : i + 1;
        bins[i] += (most - least) * c->bin;
    }
}

static void add_use(void *ctx, uint32_t channel, int32_t message, vtime begin, vtime end)
{
    struct page_channels *c = ctx;
    (void)message;
    begin = vt_max(begin, c->t->from);
    end = vt_min(end, c->t->to);
    if (channel >= c->t->topo.channels || begin > end)
        return;
    c->busy[channel] += end - begin;
    c->uses[channel]++;
    add_to_bins(c, channel, begin, end);
}

void page_channels_measure(struct page_channels *c, const struct trace *t)
{
    size_t n = t->topo.channels;
    *c = (struct page_channels){.t = t,
                                .busy = xcalloc(n, sizeof *c->busy),
                                .blocked = xcalloc(n, sizeof *c->blocked),
                                .uses = xcalloc(n, sizeof *c->uses),
                                .bins = xcalloc(n * PAGE_CHANNEL_BINS, sizeof *c->bins),
                                .bin = (double)(t->to - t->from + (t->to == t->from)) / PAGE_CHANNEL_BINS};
    trace_channel_uses(t, add_use, c);
    for (int32_t i = 0; i < t->block_count; i++)
        if (t->blocks[i].channel < n && t->blocks[i].end >= t->blocks[i].begin &&
            t->blocks[i].end != VT_NEVER)
            c->blocked[t->blocks[i].channel] += t->blocks[i].end - t->blocks[i].begin;
}

void page_channels_free(struct page_channels *c)
{
    free(c->busy);
    free(c->blocked);
    free(c->uses);
    free(c->bins);
}

json_t *page_channels_json(const struct page_channels *c)
{
    json_t *list = json_array();
    for (uint32_t i = 0; i < c->t->topo.channels; i++) {
        char name[64];
        struct topo_channel ends = topo_channel(&c->t->topo, i);
        json_t *j = json_pack("{s:s, s:I}", "name", trace_channel_name(c->t, i, name, sizeof name), "from",
                              (json_int_t)ends.from);
        json_set(j, "to", ends.kind == TOPO_LINK ? json_integer(ends.to) : json_null());
        json_append(list, j);
    }
    return list;
}

static uint64_t busy(const void *of, size_t i)
{
    return ((const struct page_channels *)of)->busy[i];
}

static uint64_t blocked(const void *of, size_t i)
{
    return ((const struct page_channels *)of)->blocked[i];
}

static uint64_t uses(const void *of, size_t i)
{
    return ((const struct page_channels *)of)->uses[i];
}

/* The share of the bin in which the channel was in use, of 65,535. */
static uint64_t share(const void *of, size_t i)
{
    const struct page_channels *c = of;
    double part = c->bins[i] / c->bin;
    return (uint64_t)((part < 1 ? part : 1) * UINT16_MAX + 0.5);
}

size_t page_channels_columns(const struct page_channels *c, struct column *columns)
{
    size_t n = c->t->topo.channels, count = 0;
    columns[count++] = (struct column){"channel.busy", COLUMN_U64, n, busy, c, NULL};
    columns[count++] = (struct column){"channel.blocked", COLUMN_U64, n, blocked, c, NULL};
    columns[count++] = (struct column){"channel.uses", COLUMN_I32, n, uses, c, NULL};
    columns[count++] = (struct column){"channel.share", COLUMN_U16, n * PAGE_CHANNEL_BINS, share, c, NULL};
    return count;
}
