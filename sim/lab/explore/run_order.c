/* run_order.c - see run_order.h. */
#include "lab/explore/run_order.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

/* What is hashed of an event: numbers in the host's byte order, since digests stay on the host. */
enum event_word { KIND, NODE, NUMBER, FROM, FROM_NUMBER, PAST_HIGH, PAST_LOW, SENT_HIGH, SENT_LOW, WORDS };
enum event_kind { RECEIVE, HANDLER, PASSED, MOMENT };

struct digest order_of_run(const struct recording *r)
{
    size_t words = 4 * r->receive_count + 3 * r->handler_count + 1;
    uint64_t *all = xcalloc(words, sizeof *all), *next = all;
    *next++ = r->receive_count;
    for (const struct rec_receive *v = r->receives; v < r->receives + r->receive_count; v++) {
        *next++ = v->node, *next++ = v->number;
        *next++ = v->from, *next++ = v->from_number;
    }
    for (const struct rec_handler *h = r->handlers; h < r->handlers + r->handler_count; h++)
        *next++ = h->node, *next++ = h->number, *next++ = h->calls;
    struct digest d = digest_of(all, words * sizeof *all);
    free(all);
    return d;
}

/* The past of a node behind its first so many events: the sum of their digests, whatever their order. */
static struct digest past_behind(const struct order *o, uint32_t node, size_t events)
{
    return o->past[o->rows->first[node] + node + events];
}

static struct digest past_at(const struct order *o, uint32_t node, vtime time)
{
    return past_behind(o, node, event_rows_until(o->rows, node, time));
}

/* What the program knew when it posted the receive. */
static struct digest past_of(const struct order *o, const struct rec_receive *v)
{
    const struct event_rows *t = o->rows;
    size_t position = t->events[t->of_receive[v - o->recording->receives]].position;
    size_t until = event_rows_until(t, v->node, v->posted);
    return past_behind(o, v->node, until < position ? until : position);
}

struct digest order_with(const struct order *o, const struct rec_receive *v, const struct rec_message *m)
{
    struct digest past = past_of(o, v), sent = past_at(o, m->from, m->sent);
    uint64_t word[WORDS] = {[KIND] = RECEIVE,      [NODE] = v->node,          [NUMBER] = v->number,
                            [FROM] = m->from,      [FROM_NUMBER] = m->number, [PAST_HIGH] = past.high,
                            [PAST_LOW] = past.low, [SENT_HIGH] = sent.high,   [SENT_LOW] = sent.low};
    return digest_of(word, sizeof word);
}

static struct digest of_handler(const struct rec_handler *h)
{
    uint64_t word[WORDS] = {[KIND] = HANDLER, [NODE] = h->node, [NUMBER] = h->number, [FROM] = h->calls};
    return digest_of(word, sizeof word);
}

struct digest order_behind(const struct order *o, const struct rec_handler *h, const struct tl_event *passed)
{
    struct digest other = o->event[passed - o->rows->events], past = past_at(o, h->node, h->at);
    uint64_t word[WORDS] = {
        [KIND] = PASSED,       [NODE] = h->node,         [NUMBER] = h->number,  [PAST_HIGH] = past.high,
        [PAST_LOW] = past.low, [SENT_HIGH] = other.high, [SENT_LOW] = other.low};
    return digest_of(word, sizeof word);
}

struct digest order_at(const struct order *o, const struct rec_handler *h, uint64_t moment)
{
    struct digest past = past_at(o, h->node, h->at);
    uint64_t word[WORDS] = {[KIND] = MOMENT, [NODE] = h->node,        [NUMBER] = h->number,
                            [FROM] = moment, [PAST_HIGH] = past.high, [PAST_LOW] = past.low};
    return digest_of(word, sizeof word);
}

/* Events come in the order of time: what is before an event has its digest already. */
static void set(struct order *o, size_t event)
{
    const struct recording *r = o->recording;
    const struct tl_event *e = &o->rows->events[event];
    struct digest *past = &o->past[event + e->node], *d = &o->event[event];
    *d = e->handler ? of_handler(&r->handlers[e->index])
                    : order_with(o, &r->receives[e->index], &r->messages[r->receives[e->index].message]);
    past[1] = (struct digest){past->high + d->high, past->low + d->low};
}

struct order order_of(const struct recording *r, const struct event_rows *t)
{
    struct order o = {.recording = r, .rows = t};
    o.event = xcalloc(t->count + 1, sizeof *o.event);
    o.past = xcalloc(t->count + t->nodes + 1, sizeof *o.past);
    for (size_t i = 0; i < t->count; i++)
        set(&o, t->by_time[i]);
    return o;
}

void order_free(struct order *o)
{
    free(o->event);
    free(o->past);
    *o = (struct order){0};
}
