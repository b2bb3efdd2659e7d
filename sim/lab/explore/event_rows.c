/* event_rows.c - see event_rows.h. */
#include "lab/explore/event_rows.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

#define ORDER(a, b) ((a) < (b) ? -1 : (a) > (b))

static int by_node(const void *a, const void *b)
{
    const struct tl_event *x = a, *y = b;
    return x->node != y->node         ? ORDER(x->node, y->node)
           : x->at != y->at           ? ORDER(x->at, y->at)
           : x->handler != y->handler ? ORDER(x->handler, y->handler)
                                      : ORDER(x->index, y->index);
}

static int by_time(const void *a, const void *b, void *events)
{
    size_t i = *(const size_t *)a, j = *(const size_t *)b;
    const struct tl_event *all = events;
    return all[i].at != all[j].at ? ORDER(all[i].at, all[j].at) : ORDER(i, j);
}

static void note_places(struct event_rows *t)
{
    size_t next = 0;
    for (uint32_t node = 0; node <= t->nodes; node++) {
        t->first[node] = next;
        for (; next < t->count && t->events[next].node == node; next++) {
            struct tl_event *e = &t->events[next];
            e->position = next - t->first[node];
            if (!e->handler)
                t->of_receive[e->index] = next;
        }
    }
    for (size_t i = 0; i < t->count; i++)
        t->by_time[i] = i;
}

struct event_rows event_rows_of(const struct recording *r)
{
    struct event_rows t = {.nodes = r->nodes + 1, .count = r->receive_count + r->handler_count};
    struct tl_event *e = t.events = xcalloc(t.count + 1, sizeof *e);
    t.first = xcalloc((size_t)t.nodes + 1, sizeof *t.first);
    t.by_time = xcalloc(t.count + 1, sizeof *t.by_time);
    t.of_receive = xcalloc(r->receive_count + 1, sizeof *t.of_receive);
    for (size_t i = 0; i < r->receive_count; i++)
        *e++ = (struct tl_event){.at = r->receives[i].at, .node = r->receives[i].node, .index = i};
    for (size_t i = 0; i < r->handler_count; i++)
        *e++ = (struct tl_event){
            .at = r->handlers[i].at, .node = r->handlers[i].node, .handler = true, .index = i};
    qsort(t.events, t.count, sizeof *t.events, by_node);
    note_places(&t);
    qsort_r(t.by_time, t.count, sizeof *t.by_time, by_time, t.events);
    return t;
}

void event_rows_free(struct event_rows *t)
{
    free(t->events);
    free(t->first);
    free(t->by_time);
    free(t->of_receive);
    *t = (struct event_rows){0};
}

size_t event_rows_until(const struct event_rows *t, uint32_t node, vtime time)
{
    const struct tl_event *row = t->events + t->first[node];
    size_t low = 0, high = t->first[node + 1] - t->first[node];
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (row[middle].at <= time)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}
