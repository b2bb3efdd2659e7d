/* livelock.c - see livelock.h. */
#include "notes/livelock.h"
#include <stdlib.h>
#include <string.h>
#include "guest/backtrace.h"
#include "kernel/crossing.h"
#include "kernel/xalloc.h"
#include "os/order.h"
#include "node/system.h"
#include "nx_api/contract/matching.h"
#include "os/charge.h"
#include "os/deferred.h"
#include "os/due.h"
#include "os/observer.h"

/* What was noted of the polls before the one at `since`. */
struct before {
    vtime since;
    struct livelock_poll *at, was, *latest;
    uint32_t rows;
};

struct livelock_note {
    struct observer observer;        /* first */
    struct livelock *signs;          /* NULL: there are none */
    struct livelock_handler handler; /* the last that has begun */
    struct before *before;           /* a ring, by deferred polls; NULL: there has been none */
    uint32_t deferred;
};

static struct livelock_note *note_of(struct observer *o)
{
    return (struct livelock_note *)o;
}

static struct livelock *signs_of(struct observer *o)
{
    struct livelock_note *own = note_of(o);
    if (!own->signs)
        own->signs = xcalloc(1, sizeof *own->signs);
    return own->signs;
}

static const struct announcements at_first, with_rows;

/* --- polls --- */

static bool is_of(const struct livelock_poll *p, const char *call, const struct selector *s, uintptr_t place)
{
    return p->call == call && p->places[0] == place && p->asks == (s != NULL) &&
           (!s || (p->select.type == s->type && p->select.node == s->node && p->select.pid == s->pid));
}

/* The entry, or that for a new one. */
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
    return shortest;
}

/* The poll, which is deferred, may have to be undone. */
static void keep(struct livelock_note *own, const struct node *n, struct livelock_poll *at)
{
    const struct livelock *l = own->signs;
    if (!own->before)
        own->before = xcalloc(DEFERRED_MOST, sizeof *own->before);
    own->before[own->deferred++ % DEFERRED_MOST] =
        (struct before){n->call.since, at, *at, l->latest, l->rows};
}

/* Undoes the notes of deferred polls: nothing has reached the node since, and the ring has them all. */
static void hear_rolled_back(struct observer *o, struct node *n)
{
    struct livelock_note *own = note_of(o);
    struct livelock *l = own->signs;
    for (uint32_t i = 0; own->before && i < DEFERRED_MOST; i++) {
        struct before *b = &own->before[(own->deferred - 1) % DEFERRED_MOST];
        if (!b->at || b->since < deferred_begins(n))
            break;
        *b->at = b->was, l->latest = b->latest, l->rows = b->rows;
        b->at = NULL;
        own->deferred--;
    }
}

static void find_places(const struct node *n, uintptr_t frame, uintptr_t *places)
{
    uintptr_t returns[LIVELOCK_PLACES];
    int depth = backtrace_walk(n, frame, returns, LIVELOCK_PLACES), count = 0;
    for (int i = 0; i < depth; i++)
        if (backtrace_in_program(n, returns[i]))
            places[count++] = returns[i];
}

static void begin_row(struct livelock *l, struct node *n, struct livelock_poll *p,
                      const struct selector *select, uintptr_t place)
{
    l->rows -= p->count > 0;
    *p = (struct livelock_poll){.call = n->call.name, .asks = select != NULL, .since = n->call.since};
    if (select)
        p->select = *select;
    p->places[0] = place;
    find_places(n, (uintptr_t)crossing_frame(), p->places);
    l->rows++;
}

/* What a poll takes. MPI's takes the computing of MPI's library, too: what has passed since the one before,
 * as far as that can be the library's. */
static vtime time_of(struct node *n, const struct livelock_poll *p, bool asks)
{
    enum { LIBRARY = 3 }; /* times a call; MPI_Test, the longest, takes 3.2 times one on the Delta */
    const struct cfg_machine *cfg = n->sys->cfg;
    vtime call = node_system_time(n, cfg->call_ps);
    if (strncmp(p->call, "MPI_", 4) == 0 && p->count)
        return vt_min(node_now(n) - p->latest, LIBRARY * call);
    return asks ? call : call + node_system_time(n, cfg->kernel_ps);
}

/* Programs that poll do so often: the latest entry is most likely the one. */
static void hear_finds_nothing(struct observer *o, struct node *n, const struct selector *select)
{
    uintptr_t place = crossing_caller();
    struct livelock *l = signs_of(o);
    struct livelock_poll *p = l->latest;
    bool same = p && is_of(p, n->call.name, select, place);
    if (!same) {
        p = find(l, n->call.name, select, place);
        same = is_of(p, n->call.name, select, place);
    }
    if (n->deferred.open)
        keep(note_of(o), n, p);
    l->latest = p;
    if (!same)
        begin_row(l, n, p, select, place);
    p->spent += time_of(n, p, select != NULL);
    p->latest = node_now(n);
    p->count++;
    if (o->hears != &with_rows)
        observer_wants(n, o, &with_rows);
}

/* A message has come to the node; NULL: a handler has run. */
static void end_rows(struct livelock *l, const struct node *n, const struct message *m)
{
    for (int i = 0; l->rows && i < LIVELOCK_POLLS; i++) {
        struct livelock_poll *p = &l->polls[i];
        if (p->count && (!p->asks || (m && matching_selects(n, &p->select, m)))) {
            p->count = 0, p->call = NULL;
            l->rows--;
        }
    }
}

static void hear_arrives(struct observer *o, struct node *n, const struct message *m)
{
    end_rows(note_of(o)->signs, n, m);
}

static void hear_handler_ends(struct observer *o, struct node *n)
{
    end_rows(note_of(o)->signs, n, NULL);
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

static void hear_handler_begins(struct observer *o, struct node *n, const struct due *d)
{
    (void)n;
    note_of(o)->handler =
        (struct livelock_handler){.handler = d->receive ? d->receive->handler : d->send->handler,
                                  .sends = !d->receive,
                                  .type = d->receive ? d->receive->select.type : 0};
}

static void hear_interrupted(struct observer *o, struct node *n, vtime begun, vtime ended)
{
    (void)n;
    struct livelock *l = signs_of(o);
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
    add_handler(s, &note_of(o)->handler, ended - begun);
}

/* --- the observer --- */

/* Messages that come do not matter before a poll has found nothing. */
static const struct announcements at_first = {.finds_nothing = hear_finds_nothing,
                                              .handler_begins = hear_handler_begins,
                                              .interrupted = hear_interrupted};
static const struct announcements with_rows = {.finds_nothing = hear_finds_nothing,
                                               .handler_begins = hear_handler_begins,
                                               .interrupted = hear_interrupted,
                                               .rolled_back = hear_rolled_back,
                                               .arrives = hear_arrives,
                                               .handler_ends = hear_handler_ends};

static struct observer *observer_at(const struct node *n)
{
    struct observer *o = observer_of(n, &at_first);
    return o ? o : observer_of(n, &with_rows);
}

void livelock_begin(struct node *n)
{
    struct livelock_note *own = xcalloc(1, sizeof *own);
    own->observer.hears = &at_first;
    observer_add(n, &own->observer);
}

void livelock_end(struct node *n)
{
    struct observer *o = observer_at(n);
    if (!o)
        return;
    observer_remove(n, o);
    free(note_of(o)->signs);
    free(note_of(o)->before);
    free(o);
}

const struct livelock *livelock_of(const struct node *n)
{
    struct observer *o = observer_at(n);
    return o ? note_of(o)->signs : NULL;
}
