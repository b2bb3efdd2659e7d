/* channel_use.c - see channel_use.h. */
#include "lab/show/channel_use.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

static void hold(void *ctx, uint32_t channel, int32_t message, vtime begin, vtime end)
{
    struct channel_use *u = ctx;
    (void)message;
    time_bins_add(&u->bins, u->held + channel, u->channels, begin, end, 1);
}

struct channel_use channel_use_make(const struct trace *t, struct time_bins bins)
{
    struct channel_use u = {.channels = t->topo.channels, .bins = bins};
    u.held = xcalloc((size_t)bins.count * u.channels, sizeof *u.held);
    trace_channel_uses(t, hold, &u);
    return u;
}

void channel_use_free(struct channel_use *u)
{
    free(u->held);
}

double channel_use_share(const struct channel_use *u, uint32_t bin, uint32_t channel)
{
    double width = time_bins_width(&u->bins, bin);
    return width > 0 ? u->held[(size_t)bin * u->channels + channel] / width : 0;
}

uint32_t channel_use_busiest(const struct channel_use *u, double *share)
{
    uint32_t busiest = 0;
    double most = 0;
    for (uint32_t c = 0; c < u->channels; c++) {
        double sum = 0;
        for (uint32_t b = 0; b < u->bins.count; b++)
            sum += u->held[(size_t)b * u->channels + c];
        if (sum > most)
            most = sum, busiest = c;
    }
    *share = most / (double)(u->bins.to - u->bins.from);
    return busiest;
}

bool channel_is_real(const struct topo *topo, uint32_t channel)
{
    struct topo_channel c = topo_channel(topo, channel);
    struct topo_walk w;
    uint32_t step = channel, routers = topo->addresses; /* in a mesh, those too that no I/O node uses */
    if (topo->rows)
        routers = topo->positions + (topo->services + topo->rows - 1) / topo->rows * topo->rows;
    if (c.kind != TOPO_LINK)
        return true;
    if (c.to >= routers || topo_hops(topo, c.from, c.to) != 1)
        return false;
    topo_begin(topo, &w, c.from, c.to);
    return topo_step(topo, &w, &step) && topo_step(topo, &w, &step) && step == channel;
}

struct mesh_spot mesh_spot_of(const struct topo *topo, uint32_t address)
{
    if (address < topo->positions)
        return (struct mesh_spot){address % topo->columns, address / topo->columns};
    uint32_t i = address - topo->positions;
    return (struct mesh_spot){topo->columns + i / topo->rows, i % topo->rows};
}
