/* block_holders.c - see block_holders.h. */
#include "lab/why/block_holders.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

/* The blocks by channel, then end; and for each the end of its holder's use, so far as known. */
struct search {
    const struct trace *t;
    int32_t *blocks;
    vtime *held_until;
    int32_t *holder;
};

static int compare(const void *x, const void *y, void *of)
{
    const int32_t a = *(const int32_t *)x, b = *(const int32_t *)y;
    const struct trace_block *blocks = of, *p = &blocks[a], *q = &blocks[b];
    if (p->channel != q->channel)
        return p->channel < q->channel ? -1 : 1;
    if (p->end != q->end)
        return p->end < q->end ? -1 : 1;
    return a < b ? -1 : a > b;
}

/* The first block in the order that is for the channel and does not end before t. */
static int32_t first_at(const struct search *s, uint32_t channel, vtime t)
{
    int32_t low = 0, high = s->t->block_count;
    while (low < high) {
        int32_t middle = low + (high - low) / 2;
        const struct trace_block *b = &s->t->blocks[s->blocks[middle]];
        if (b->channel < channel || (b->channel == channel && b->end < t))
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* A message held a channel: is it what ended a block last? Blocks of one channel end one after the other,
 * each when its holder gives the channel back: so only the next blocks can be concerned. */
static void held(void *ctx, uint32_t channel, int32_t message, vtime begin, vtime end)
{
    struct search *s = ctx;
    for (int32_t i = first_at(s, channel, end); i < s->t->block_count; i++) {
        int32_t block = s->blocks[i];
        const struct trace_block *b = &s->t->blocks[block];
        if (b->channel != channel || b->begin >= end)
            return;
        if (b->message == message || begin >= b->end)
            continue;
        if (s->holder[block] != TRACE_NONE && s->held_until[block] >= end)
            return; /* others held the channel later: for the blocks behind as well */
        s->holder[block] = message;
        s->held_until[block] = end;
    }
}

int32_t *block_holders_find(const struct trace *t)
{
    const size_t count = (size_t)t->block_count;
    struct search s = {t, xcalloc(count, sizeof *s.blocks), xcalloc(count, sizeof *s.held_until),
                       xcalloc(count, sizeof *s.holder)};
    for (int32_t i = 0; i < t->block_count; i++)
        s.blocks[i] = i, s.holder[i] = TRACE_NONE;
    if (count) {
        qsort_r(s.blocks, count, sizeof *s.blocks, compare, t->blocks);
        trace_channel_uses(t, held, &s);
    }
    free(s.blocks);
    free(s.held_until);
    return s.holder;
}
