/* flow.c - see flow.h. A hash table of senders, each with its messages in order, in a ring. They are mostly added behind the
 * last and taken as the first. */
#include "net/flow.h"
#include <assert.h>
#include <stdlib.h>
#include "net/proto_parts.h"

struct flow {
    uint32_t source;
    uint32_t first, count, room; /* of the ring; room is a power of 2, or 0: nobody's place */
    struct trip **ring;
};

struct flows {
    struct flow *table;
    uint32_t used, room; /* a power of 2 */
};

static void *checked(void *p)
{
    if (!p)
        abort();
    return p;
}

struct flows *flows_new(void)
{
    struct flows *f = checked(calloc(1, sizeof *f));
    f->room = 16;
    f->table = checked(calloc(f->room, sizeof *f->table));
    return f;
}

void flows_free(struct flows *f)
{
    if (!f)
        return;
    for (uint32_t i = 0; i < f->room; i++)
        free(f->table[i].ring);
    free(f->table);
    free(f);
}

/* Where a sender's flow is, or would be. */
static struct flow *place_of(const struct flows *f, uint32_t source)
{
    uint32_t i = (source * UINT32_C(2654435769)) & (f->room - 1);
    while (f->table[i].room && f->table[i].source != source)
        i = (i + 1) & (f->room - 1);
    return &f->table[i];
}

static void grow_table(struct flows *f)
{
    struct flows old = *f;
    f->room *= 2;
    f->table = checked(calloc(f->room, sizeof *f->table));
    for (uint32_t i = 0; i < old.room; i++)
        if (old.table[i].room)
            *place_of(f, old.table[i].source) = old.table[i];
    free(old.table);
}

static struct trip **nth(const struct flow *w, uint32_t i)
{
    return &w->ring[(w->first + i) & (w->room - 1)];
}

static void grow_ring(struct flow *w)
{
    struct flow old = *w;
    w->room = old.room ? 2 * old.room : 8;
    w->ring = checked(calloc(w->room, sizeof(struct trip *)));
    w->first = 0;
    for (uint32_t i = 0; i < old.count; i++)
        w->ring[i] = *nth(&old, i);
    free(old.ring);
}

void flows_add(struct flows *f, struct trip *t)
{
    struct flow *w = place_of(f, t->source);
    if (!w->room && 4 * ++f->used > 3 * f->room) {
        grow_table(f);
        w = place_of(f, t->source);
    }
    w->source = t->source;
    if (w->count == w->room)
        grow_ring(w);
    uint32_t i = w->count++;
    for (; i > 0 && (*nth(w, i - 1))->order > t->order; i--)
        *nth(w, i) = *nth(w, i - 1);
    *nth(w, i) = t;
}

void flows_remove(struct flows *f, struct trip *t)
{
    struct flow *w = place_of(f, t->source);
    uint32_t i = 0;
    while (i < w->count && *nth(w, i) != t)
        i++;
    assert(i < w->count);
    for (; i > 0; i--)
        *nth(w, i) = *nth(w, i - 1);
    w->first = (w->first + 1) & (w->room - 1);
    w->count--;
}

struct trip *flows_first(const struct flows *f, uint32_t source)
{
    const struct flow *w = place_of(f, source);
    return w->room && w->count ? *nth(w, 0) : NULL;
}
