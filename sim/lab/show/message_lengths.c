/* message_lengths.c - see message_lengths.h. */
#include "lab/show/message_lengths.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

int length_class(uint64_t bytes)
{
    return bytes ? 64 - __builtin_clzll(bytes) : 0;
}

static int by_size(const void *a, const void *b)
{
    const uint64_t *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

struct message_lengths message_lengths_make(const struct trace *t, const struct node_rows *r)
{
    struct message_lengths l = {.first_class = LENGTH_CLASSES, .last_class = -1};
    uint64_t *all = xcalloc((size_t)t->message_count, sizeof *all);
    for (const struct trace_message *m = t->messages; m < t->messages + t->message_count; m++) {
        if (!message_counts(t, r, m))
            continue;
        int k = length_class(m->bytes);
        struct message_sum *sum = &l.sums[k][m->is_long];
        sum->messages++, sum->bytes += m->bytes;
        l.bytes += m->bytes;
        l.first_class = k < l.first_class ? k : l.first_class;
        l.last_class = k > l.last_class ? k : l.last_class;
        all[l.messages++] = m->bytes;
    }
    qsort(all, l.messages, sizeof *all, by_size);
    if (l.messages)
        l.shortest = all[0], l.longest = all[l.messages - 1], l.median = all[(l.messages - 1) / 2];
    free(all);
    return l;
}
