/* past_messages.c - see past_messages.h. */
#include "nx_api/mpi/past_messages.h"

enum { MOST = 8 };

struct ring {
    struct past_item last[MOST];
    uint64_t count; /* of all */
};

static struct ring taken, lost;

static struct past_item *add(struct ring *r, enum waitfor_fate fate, const struct message *m)
{
    struct past_item *i = &r->last[r->count++ % MOST];
    *i = (struct past_item){.fate = fate,
                            .type = m->type,
                            .from = m->source,
                            .pid = m->pid,
                            .bytes = m->bytes,
                            .by = {-1, -1, -1}};
    return i;
}

void past_taken(const struct node *n, const struct receive *r)
{
    struct past_item *i = add(&taken, r->handler ? WAITFOR_HANDLED : WAITFOR_RECEIVED, r->m);
    i->by = r->select;
    i->call = r->handler ? "hrecv" : n->call.name;
    i->place = r->handler ? (uintptr_t)r->handler + 1 : n->call.caller;
}

void past_lost(enum waitfor_fate fate, const struct message *m)
{
    add(&lost, fate, m);
}

static unsigned kept(const struct ring *r)
{
    return r->count < MOST ? (unsigned)r->count : MOST;
}

const struct past_item *past_at(unsigned i)
{
    const struct ring *r = &taken;
    if (i >= kept(r)) {
        i -= kept(r);
        r = &lost;
    }
    return i < kept(r) ? &r->last[(r->count - kept(r) + i) % MOST] : NULL;
}
