/* channel_use.h - the times for which each channel was held in each bin of time, and where routers lie. */
#ifndef LAB_SHOW_CHANNEL_USE_H
#define LAB_SHOW_CHANNEL_USE_H
#include "lab/draw/time_bins.h"
#include "lab/trace/trace_model.h"

struct channel_use {
    uint32_t channels;
    struct time_bins bins;
    double *held; /* picoseconds: [bin][channel] */
};

struct channel_use channel_use_make(const struct trace *t, struct time_bins bins);
void channel_use_free(struct channel_use *u);
/* The share of the bin's time in which a message held the channel, 0 to 1. */
double channel_use_share(const struct channel_use *u, uint32_t bin, uint32_t channel);
/* The channel that was held longest in all bins together; 0 if none was. *share: of the whole time. */
uint32_t channel_use_busiest(const struct channel_use *u, double *share);

/* Can a route use the channel? False: it would lead over the edge of a mesh. */
bool channel_is_real(const struct topo *topo, uint32_t channel);

/* Where an address lies in a mesh; those of I/O nodes lie in columns from topo.columns on. */
struct mesh_spot {
    uint32_t column, row;
};
struct mesh_spot mesh_spot_of(const struct topo *topo, uint32_t address);
#endif
