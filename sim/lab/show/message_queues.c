/* message_queues.c - see message_queues.h. */
#include "lab/show/message_queues.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

/* A message begins to wait at a node, or ends to. */
struct change {
    vtime time;
    int32_t node;
    int64_t by;
};

/* By node, then time; at one time those that end first, so that a wait of no length is none. */
static int by_node(const void *a, const void *b)
{
    const struct change *x = a, *y = b;
    if (x->node != y->node)
        return x->node < y->node ? -1 : 1;
    if (x->time != y->time)
        return x->time < y->time ? -1 : 1;
    return (x->by > y->by) - (x->by < y->by);
}

static void find_longest(struct message_queues *q, struct change *list, size_t count)
{
    int64_t length = 0;
    qsort(list, count, sizeof *list, by_node);
    for (const struct change *c = list; c < list + count; c++) {
        length += c->by; /* it is 0 again behind the last of a node */
        if (length > (int64_t)q->longest.length)
            q->longest.length = (uint64_t)length, q->longest.node = c->node, q->longest.time = c->time;
    }
}

struct message_queues message_queues_make(const struct trace *t, const struct node_rows *r,
                                          struct time_bins bins, bool bytes)
{
    struct message_queues q = {.rows = r->count, .bins = bins, .bytes = bytes, .longest.node = TRACE_NONE};
    q.sums = xcalloc((size_t)q.rows * bins.count * QUEUE_KINDS, sizeof *q.sums);
    struct change *changes = xcalloc(2 * (size_t)t->message_count, sizeof *changes);
    size_t count = 0;
    for (const struct trace_message *m = t->messages; m < t->messages + t->message_count; m++) {
        int32_t row = m->to == TRACE_NONE ? TRACE_NONE : r->row[m->to];
        if (row == TRACE_NONE)
            continue;
        double *sums = q.sums + (size_t)row * bins.count * QUEUE_KINDS;
        int64_t weight = bytes ? (int64_t)m->bytes : 1;
        time_bins_add(&bins, sums + QUEUE_COMING, QUEUE_KINDS, m->sent, m->complete, (double)weight);
        time_bins_add(&bins, sums + QUEUE_WAITING, QUEUE_KINDS, m->complete, m->taken, (double)weight);
        vtime begin = vt_max(m->complete, bins.from), end = vt_min(m->taken, bins.to);
        if (begin < end) {
            changes[count++] = (struct change){begin, m->to, weight};
            changes[count++] = (struct change){end, m->to, -weight};
        }
    }
    find_longest(&q, changes, count);
    free(changes);
    return q;
}

void message_queues_free(struct message_queues *q)
{
    free(q->sums);
}

double message_queues_mean(const struct message_queues *q, int32_t row, uint32_t bin, enum queue_kind kind)
{
    double width = time_bins_width(&q->bins, bin);
    return width > 0 ? q->sums[((size_t)row * q->bins.count + bin) * QUEUE_KINDS + kind] / width : 0;
}
