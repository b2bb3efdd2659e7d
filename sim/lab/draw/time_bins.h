/* time_bins.h - an interval of virtual time, divided into bins of one width (to the picosecond). What
 * lasts adds to each bin the part of its time that lies in the bin: the sums are exact, however short it
 * is. */
#ifndef LAB_DRAW_TIME_BINS_H
#define LAB_DRAW_TIME_BINS_H
#include <stddef.h>
#include <stdint.h>
#include "kernel/vtime.h"

struct time_bins {
    vtime from, to; /* from < to */
    uint32_t count;
};

/* At most so many bins: none is shorter than a picosecond. from < to. */
struct time_bins time_bins_make(vtime from, vtime to, uint32_t most);
/* The beginning of bin i; of bin `count`: the end of the interval. */
vtime time_bins_edge(const struct time_bins *b, uint32_t i);
double time_bins_width(const struct time_bins *b, uint32_t i); /* picoseconds */
/* Adds weight x picoseconds to sums[i * stride] of each bin i that [begin, end) overlaps. Sums are double:
 * whole numbers up to 2^53 ps (2.5 hours) are exact, and larger ones to 16 digits. */
void time_bins_add(const struct time_bins *b, double *sums, size_t stride, vtime begin, vtime end,
                   double weight);
#endif
