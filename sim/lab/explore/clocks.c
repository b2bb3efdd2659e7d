/* clocks.c - see clocks.h. */
#include "lab/explore/clocks.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

/* The clock of a node at a time: that behind its latest event. NULL: no event was before. */
static const uint32_t *clock_at(const struct clocks *c, uint32_t node, vtime time)
{
    const struct event_rows *t = c->rows;
    size_t before = event_rows_until(t, node, time);
    return before ? c->after + (t->first[node] + before - 1) * t->nodes : NULL;
}

static void join(uint32_t *clock, const uint32_t *other, uint32_t nodes)
{
    for (uint32_t i = 0; other && i < nodes; i++)
        if (other[i] > clock[i])
            clock[i] = other[i];
}

static void set(struct clocks *c, const struct recording *r, size_t event)
{
    const struct event_rows *t = c->rows;
    const struct tl_event *e = &t->events[event];
    uint32_t *clock = c->after + event * t->nodes;
    if (e->position)
        join(clock, clock - t->nodes, t->nodes);
    if (!e->handler) {
        const struct rec_message *m = &r->messages[r->receives[e->index].message];
        join(clock, clock_at(c, m->from, m->sent), t->nodes);
    }
    clock[e->node] = (uint32_t)e->position + 1;
}

struct clocks clocks_of(const struct recording *r, const struct event_rows *t, size_t most)
{
    struct clocks c = {.rows = t};
    if (t->count > most / t->nodes)
        return c;
    c.after = xcalloc(t->count * t->nodes + 1, sizeof *c.after);
    for (size_t i = 0; i < t->count; i++) /* a message is sent before it is received: in the order of time */
        set(&c, r, t->by_time[i]);
    return c;
}

void clocks_free(struct clocks *c)
{
    free(c->after);
    *c = (struct clocks){0};
}

bool clocks_before_sending(const struct clocks *c, const struct tl_event *e, const struct rec_message *m)
{
    if (m->sent < e->at)
        return false;
    if (!c->after)
        return true;
    const uint32_t *clock = clock_at(c, m->from, m->sent);
    return clock && clock[e->node] > e->position;
}
