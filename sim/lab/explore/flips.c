/* flips.c - see flips.h. */
#include "lab/explore/flips.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "nx_api/contract/message.h"

/* So many later messages are looked at for a receive, so many of them may be its candidates; and a handler is
 * tried at so many moments. */
enum { LOOKED_AT = 256, CANDIDATES = 8, MOMENTS = 7 };

struct flip_search {
    const struct order *o;
    const struct clocks *c;
    const struct delay_bounds *bounds;
    const struct rec_message **to; /* messages that came, sorted by receiver, then by when they came */
    size_t *first;                 /* of each receiver, into `to` */
    struct flips found;
};

static void add(struct flip_search *s, struct flip f)
{
    struct flips *all = &s->found;
    all->list = xgrown(all->list, all->count, sizeof *all->list);
    all->list[all->count++] = f;
}

static int64_t left_of(const struct flip_search *s, enum delay_kind kind, uint32_t node, uint64_t index)
{
    return s->bounds->most[kind] - delays_value(&s->o->recording->delays, kind, node, index);
}

/* --- places --------------------------------------------------------------------------------------------- */

static uint64_t mixed(uint64_t hash, const void *bytes, size_t size)
{
    const unsigned char *byte = bytes;
    for (size_t i = 0; i < size; i++) /* FNV-1a */
        hash = (hash ^ byte[i]) * UINT64_C(0x100000001b3);
    return hash;
}

static uint64_t place_of(bool handler, const char *line, int64_t typesel)
{
    uint64_t hash = mixed(UINT64_C(0xcbf29ce484222325), &handler, sizeof handler);
    if (line)
        return mixed(hash, line, strlen(line));
    return mixed(hash, &typesel, sizeof typesel);
}

/* --- messages ------------------------------------------------------------------------------------------- */

static bool was_taken_before(const struct flip_search *s, const struct rec_message *m,
                             const struct rec_receive *v)
{
    return m->taken != REC_NONE && s->o->recording->receives[m->taken].number <= v->number;
}

/* Could the receive have got it? */
static bool is_candidate(const struct flip_search *s, const struct rec_receive *v,
                         const struct rec_message *m)
{
    const struct event_rows *t = s->o->rows;
    const struct tl_event *e = &t->events[t->of_receive[v - s->o->recording->receives]];
    return m->from != v->from && mailbox_selects(v->typesel, m->type) && !was_taken_before(s, m, v) &&
           !clocks_before_sending(s->c, e, m);
}

/* A message that its sender's earlier messages keep from being first: they are received in order. */
static bool is_seen(const struct rec_message *m, const uint32_t *senders, int count)
{
    for (int i = 0; i < count; i++)
        if (senders[i] == m->from)
            return true;
    return false;
}

static size_t first_behind(const struct flip_search *s, const struct rec_message *winner)
{
    size_t low = s->first[winner->to], high = s->first[winner->to + 1];
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (s->to[middle]->came < winner->came)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* The messages that came behind the one that the receive got. */
static void of_receive(struct flip_search *s, const struct rec_receive *v)
{
    const struct rec_message *won = &s->o->recording->messages[v->message];
    uint32_t senders[CANDIDATES];
    int count = 0;
    if (v->selected != REC_ANY || won->came == VT_NEVER || won->index == REC_UNKNOWN || v->at == VT_NEVER)
        return;
    int64_t most = left_of(s, DELAY_MESSAGE, won->from, won->index) + left_of(s, DELAY_START, won->from, 0);
    size_t begin = first_behind(s, won), end = s->first[won->to + 1];
    for (size_t i = begin; i < end && i - begin < LOOKED_AT && count < CANDIDATES; i++) {
        const struct rec_message *m = s->to[i];
        int64_t later = (int64_t)(m->came - won->came);
        if (later >= most)
            return;
        if (!is_candidate(s, v, m) || is_seen(m, senders, count))
            continue;
        senders[count++] = m->from;
        add(s, (struct flip){.order = order_with(s->o, v, m),
                             .place = place_of(false, v->line, v->typesel),
                             .node = v->node,
                             .from = won->from,
                             .index = won->index,
                             .later = later});
    }
}

/* --- handlers ------------------------------------------------------------------------------------------- */

/* The time that the handler must pass: when the program posted the receive, or another handler ran. */
static vtime time_of(const struct flip_search *s, const struct tl_event *e)
{
    const struct recording *r = s->o->recording;
    return e->handler ? r->handlers[e->index].at : r->receives[e->index].posted;
}

/* The message that the handler runs for; NULL: none, or not known. */
static const struct rec_message *message_of(const struct recording *r, const struct rec_handler *h)
{
    const struct rec_receive *v =
        h->receive == REC_NONE ? NULL : recording_receive(r, h->node, (uint64_t)h->receive);
    const struct rec_message *m = v ? &r->messages[v->message] : NULL;
    return m && m->index != REC_UNKNOWN ? m : NULL;
}

/* By how much the handler can be later. */
static int64_t most_of(const struct flip_search *s, const struct rec_handler *h, const struct rec_message *m)
{
    int64_t most = left_of(s, DELAY_INTERRUPT, h->node, h->number);
    if (m)
        most += left_of(s, DELAY_MESSAGE, m->from, m->index) + left_of(s, DELAY_START, m->from, 0);
    return most;
}

static void add_handler(struct flip_search *s, const struct rec_handler *h, struct digest order,
                        int64_t later)
{
    const struct rec_message *m = message_of(s->o->recording, h);
    add(s, (struct flip){.order = order,
                         .place = place_of(true, h->line, 0),
                         .node = h->node,
                         .handler = true,
                         .number = h->number,
                         .from = m ? m->from : 0,
                         .index = m ? m->index : REC_UNKNOWN,
                         .later = later});
}

/* Moments at equal distances between the handler and what comes next. */
static void add_moments(struct flip_search *s, const struct rec_handler *h, int64_t until)
{
    for (int64_t i = 1; i <= MOMENTS; i++)
        add_handler(s, h, order_at(s->o, h, (uint64_t)i), until * i / (MOMENTS + 1));
}

/* The first two things that its node does behind the handler, and moments before the first. */
static void of_handler(struct flip_search *s, const struct rec_handler *h)
{
    const struct event_rows *t = s->o->rows;
    if (h->at == VT_NEVER)
        return;
    int64_t most = most_of(s, h, message_of(s->o->recording, h)), first = most;
    const struct tl_event *e = t->events + t->first[h->node] + event_rows_until(t, h->node, h->at),
                          *end = t->events + t->first[h->node + 1];
    for (int found = 0; e < end && found < 2; e++) {
        vtime time = time_of(s, e);
        if (time == VT_NEVER || time <= h->at || (int64_t)(time - h->at) >= most)
            continue;
        first = found++ ? first : (int64_t)(time - h->at);
        add_handler(s, h, order_behind(s->o, h, e), (int64_t)(time - h->at));
    }
    if (first > 0)
        add_moments(s, h, first);
}

/* --- all ------------------------------------------------------------------------------------------------ */

#define ORDER(a, b) ((a) < (b) ? -1 : (a) > (b))

static int by_coming(const void *a, const void *b)
{
    const struct rec_message *x = *(const struct rec_message *const *)a,
                             *y = *(const struct rec_message *const *)b;
    return x->to != y->to ? ORDER(x->to, y->to) : x->came != y->came ? ORDER(x->came, y->came) : ORDER(x, y);
}

static void sort_messages(struct flip_search *s)
{
    const struct recording *r = s->o->recording;
    size_t count = 0, next = 0;
    s->to = xcalloc(r->message_count + 1, sizeof *s->to);
    s->first = xcalloc((size_t)r->nodes + 2, sizeof *s->first);
    for (size_t i = 0; i < r->message_count; i++)
        if (r->messages[i].came != VT_NEVER)
            s->to[count++] = &r->messages[i];
    qsort(s->to, count, sizeof *s->to, by_coming);
    for (uint32_t node = 0; node <= r->nodes + 1; node++) {
        s->first[node] = next;
        while (next < count && s->to[next]->to == node)
            next++;
    }
}

struct flips flips_of(const struct order *o, const struct clocks *c, const struct delay_bounds *bounds)
{
    struct flip_search s = {.o = o, .c = c, .bounds = bounds};
    sort_messages(&s);
    for (size_t i = 0; i < o->rows->count; i++) {
        const struct tl_event *e = &o->rows->events[o->rows->by_time[i]];
        if (e->handler)
            of_handler(&s, &o->recording->handlers[e->index]);
        else
            of_receive(&s, &o->recording->receives[e->index]);
    }
    free(s.to);
    free(s.first);
    return s.found;
}

/* Adds to a delay what its bound allows; returns what is left. */
static int64_t add_within(const struct delay_bounds *bounds, struct delays *d, enum delay_kind kind,
                          uint32_t node, uint64_t index, int64_t later)
{
    int64_t room = bounds->most[kind] - delays_value(d, kind, node, index);
    int64_t part = later < room ? later : room;
    if (part > 0)
        delays_add(d, kind, node, index, part);
    return part > 0 ? later - part : later;
}

bool flip_delay(const struct flip *f, int64_t margin, const struct delay_bounds *bounds, struct delays *d)
{
    int64_t left = f->later + margin;
    if (f->handler)
        left = add_within(bounds, d, DELAY_INTERRUPT, f->node, f->number, left);
    if (left > 0 && f->index != REC_UNKNOWN)
        left = add_within(bounds, d, DELAY_MESSAGE, f->from, f->index, left);
    if (left > 0 && f->index != REC_UNKNOWN)
        left = add_within(bounds, d, DELAY_START, f->from, 0, left);
    return left <= 0;
}

bool flips_add_wanted(struct flips *all, const struct order *o, const struct delay_bounds *bounds,
                      const struct wanted_interrupt *w)
{
    const struct rec_handler *h = recording_handler(o->recording, w->node, w->handler);
    struct flip_search s = {.o = o, .bounds = bounds, .found = *all};
    if (!h || h->at == VT_NEVER || h->at >= w->time)
        return false;
    int64_t later = (int64_t)(w->time - h->at);
    if (later >= most_of(&s, h, message_of(o->recording, h)))
        return false;
    add_handler(&s, h, order_at(o, h, w->time), later);
    *all = s.found;
    return true;
}
