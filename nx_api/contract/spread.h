/* spread.h - the least, the most and the sum of a figure over nodes, for summaries. */
#ifndef CONTRACT_SPREAD_H
#define CONTRACT_SPREAD_H
#include <stdint.h>

/* All 0 at first. */
struct spread {
    double least, most, sum;
    uint32_t count;
};

static inline void spread_add(struct spread *s, double x)
{
    if (s->count == 0 || x < s->least)
        s->least = x;
    if (s->count == 0 || x > s->most)
        s->most = x;
    s->sum += x;
    s->count++;
}
#endif
