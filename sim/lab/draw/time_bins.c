/* time_bins.c - see time_bins.h. */
#include "lab/draw/time_bins.h"

struct time_bins time_bins_make(vtime from, vtime to, uint32_t most)
{
    return (struct time_bins){from, to, (uint32_t)vt_min(most, to - from)};
}

vtime time_bins_edge(const struct time_bins *b, uint32_t i)
{
    return b->from + (vtime)((unsigned __int128)(b->to - b->from) * i / b->count);
}

double time_bins_width(const struct time_bins *b, uint32_t i)
{
    return (double)(time_bins_edge(b, i + 1) - time_bins_edge(b, i));
}

/* The bin of t, or the one before, if t is its end. */
static uint32_t bin_of(const struct time_bins *b, vtime t)
{
    return (uint32_t)((unsigned __int128)(t - b->from) * b->count / (b->to - b->from));
}

void time_bins_add(const struct time_bins *b, double *sums, size_t stride, vtime begin, vtime end,
                   double weight)
{
    begin = vt_max(begin, b->from);
    end = vt_min(end, b->to);
    if (begin >= end)
        return;
    for (uint32_t i = bin_of(b, begin); begin < end; i++) {
        vtime until = vt_min(end, time_bins_edge(b, i + 1));
        sums[i * stride] += weight * (double)(until - begin);
        begin = until;
    }
}
