/* livelock.c - see livelock.h. */
#include "os/livelock.h"
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "node/system.h"
#include "nx_api/contract/matching.h"
#include "os/gate.h"

static struct livelock *of_node(struct node *n)
{
    if (!n->livelock)
        n->livelock = xcalloc(1, sizeof *n->livelock);
    return n->livelock;
}

/* --- polls --- */

static bool is_of(const struct livelock_poll *p, const char *call, const struct selector *s, uintptr_t place)
{
    return p->call == call && p->places[0] == place && p->asks == (s != NULL) &&
           (!s || (p->select.type == s->type && p->select.node == s->node && p->select.pid == s->pid));
}

/* The entry, or the place for a new one. */
static struct livelock_poll *find(struct livelock *l, const char *call, const struct selector *s,
                                  uintptr_t place)
{
    struct livelock_poll *shortest = &l->polls[0];
    for (int i = 0; i < LIVELOCK_POLLS; i++) {
        struct livelock_poll *p = &l->polls[i];
        if (is_of(p, call, s, place))
            return p;
        if (p->count < shortest->count)
            shortest = p;
    }
    l->rows -= shortest->count > 0;
    *shortest = (struct livelock_poll){0};
    return shortest;
}

static void begin_row(struct node *n, struct livelock_poll *p, const struct selector *select, uintptr_t place)
{
    *p = (struct livelock_poll){.call = n->call, .asks = select != NULL, .since = n->call_since};
    if (select)
        p->select = *select;
    p->places[0] = place;
    n->livelock->rows++;
}

/* Programs that poll do so often: the latest entry is most likely the one. */
uintptr_t *livelock_found_nothing(struct node *n, const struct selector *select, uintptr_t place, vtime spent)
{
    struct livelock *l = of_node(n);
    struct livelock_poll *p = l->latest;
    if (!p || !is_of(p, n->call, select, place))
        p = l->latest = find(l, n->call, select, place);
    bool begins = p->count == 0;
    if (begins)
        begin_row(n, p, select, place);
    p->count++;
    p->spent += spent;
    return begins ? p->places : NULL;
}

void livelock_end_rows(struct node *n, const struct message *m)
{
    for (int i = 0; i < LIVELOCK_POLLS; i++) {
        struct livelock_poll *p = &n->livelock->polls[i];
        if (p->count && (!p->asks || (m && matching_selects(n, &p->select, m)))) {
            p->count = 0, p->call = NULL;
            n->livelock->rows--;
        }
    }
}

/* --- handlers --- */

static void add_handler(struct livelock_siege *s, const struct livelock_handler *h, vtime time)
{
    uint32_t i = 0;
    while (i < s->kinds &&
           (s->by[i].handler != h->handler || s->by[i].sends != h->sends || s->by[i].type != h->type))
        i++;
    if (i == LIVELOCK_HANDLERS)
        return;
    if (i == s->kinds)
        s->by[s->kinds++] = *h;
    s->by[i].count++;
    s->by[i].time += time;
}

void livelock_interrupted(struct node *n, const struct livelock_handler *h, vtime begun, vtime ended)
{
    struct livelock *l = of_node(n);
    struct livelock_siege *s = &l->siege;
    if (s->handlers && 2 * s->stood < begun - s->since) {
        if (s->stood > l->worst.stood)
            l->worst = *s;
        s->handlers = 0;
    }
    if (!s->handlers)
        *s = (struct livelock_siege){.since = begun};
    s->handlers++;
    s->stood += ended - begun;
    s->until = ended;
    add_handler(s, h, ended - begun);
}

void livelock_free(struct node *n)
{
    free(n->livelock);
    n->livelock = NULL;
}
