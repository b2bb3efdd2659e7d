/* wait_enders.c - see wait_enders.h. */
#include "lab/why/wait_enders.h"
#include <assert.h>
#include <stdlib.h>
#include "kernel/xalloc.h"

/* --- messages by node and time --- */

static int by_node_and_time(int32_t a_node, vtime a_time, int32_t a, int32_t b_node, vtime b_time, int32_t b)
{
    if (a_node != b_node)
        return a_node < b_node ? -1 : 1;
    if (a_time != b_time)
        return a_time < b_time ? -1 : 1;
    return a < b ? -1 : a > b;
}

static int compare_arriving(const void *x, const void *y, void *messages)
{
    const int32_t a = *(const int32_t *)x, b = *(const int32_t *)y;
    const struct trace_message *m = messages;
    return by_node_and_time(m[a].to, m[a].complete, a, m[b].to, m[b].complete, b);
}

static int compare_leaving(const void *x, const void *y, void *messages)
{
    const int32_t a = *(const int32_t *)x, b = *(const int32_t *)y;
    const struct trace_message *m = messages;
    return by_node_and_time(m[a].from, message_leaves(&m[a]), a, m[b].from, message_leaves(&m[b]), b);
}

static int32_t *sorted(const struct trace *t, int (*compare)(const void *, const void *, void *))
{
    int32_t *list = xmalloc((size_t)t->message_count * sizeof *list);
    for (int32_t i = 0; i < t->message_count; i++)
        list[i] = i;
    if (t->message_count)
        qsort_r(list, (size_t)t->message_count, sizeof *list, compare, t->messages);
    return list;
}

struct wait_enders wait_enders_new(const struct trace *t)
{
    return (struct wait_enders){t, sorted(t, compare_arriving), sorted(t, compare_leaving)};
}

void wait_enders_free(struct wait_enders *e)
{
    free(e->arriving);
    free(e->leaving);
}

/* The position in a list behind the last message of a node at or before a time. */
static int32_t behind(const struct wait_enders *e, bool leaving, int32_t node, vtime at)
{
    const int32_t *list = leaving ? e->leaving : e->arriving;
    int32_t low = 0, high = e->t->message_count;
    while (low < high) {
        int32_t middle = low + (high - low) / 2;
        const struct trace_message *m = &e->t->messages[list[middle]];
        vtime time = leaving ? message_leaves(m) : m->complete;
        int32_t of = leaving ? m->from : m->to;
        if (of < node || (of == node && time <= at))
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* --- what ended a wait --- */

static bool call_sent(const struct trace_call *c, int32_t message)
{
    return c->sent != TRACE_NONE && message >= c->sent;
}

/* How well the message fits the wait that it may have ended; the most counts. */
static int fit(const struct trace *t, const struct trace_wait *w, int32_t message, bool leaving)
{
    const struct trace_message *m = &t->messages[message];
    const struct trace_call *c = &t->calls[w->call];
    if (leaving)
        return (w->sends ? 2 : 0) + (m->sending == w->call || call_sent(c, message) ? 2 : 0);
    return (w->sends ? 0 : 2) + (c->taken == message ? 2 : 0) + (m->taking == w->call ? 1 : 0) +
           (w->has_type && w->type == m->type ? 1 : 0);
}

/* Of the messages that arrived (or left) last in the wait: the one that fits best, if it is better than the
 * one there is. */
static void consider(const struct wait_enders *e, const struct trace_wait *w, bool leaving,
                     struct wait_ender *best, int *best_fit)
{
    const int32_t *list = leaving ? e->leaving : e->arriving;
    for (int32_t i = behind(e, leaving, w->node, w->end) - 1; i >= 0; i--) {
        const struct trace_message *m = &e->t->messages[list[i]];
        vtime at = leaving ? message_leaves(m) : m->complete;
        if ((leaving ? m->from : m->to) != w->node || at <= w->begin)
            return;
        if (best->message != TRACE_NONE && at < best->at)
            return;
        int fits = fit(e->t, w, list[i], leaving);
        if (best->message == TRACE_NONE || at > best->at || fits > *best_fit) {
            *best = (struct wait_ender){list[i], TRACE_NONE, leaving, at};
            *best_fit = fits;
        }
    }
}

/* The message that made a handler due, which began when the wait ended. */
static bool by_handler(const struct trace *t, const struct piece_map *map, const struct trace_wait *w,
                       struct wait_ender *ender)
{
    int32_t h = piece_map_handler(map, w->node, w->end);
    if (h == TRACE_NONE || t->handlers[h].due != w->end || t->handlers[h].message == TRACE_NONE)
        return false;
    int32_t message = t->handlers[h].message;
    const struct trace_message *m = &t->messages[message];
    *ender = (struct wait_ender){message, h, m->to != w->node || m->complete != w->end, w->end};
    return true;
}

struct wait_ender wait_enders_of(const struct wait_enders *e, const struct piece_map *map, int32_t wait)
{
    const struct trace_wait *w = &e->t->waits[wait];
    struct wait_ender ender = {TRACE_NONE, TRACE_NONE, false, 0};
    int fits = 0;
    if (by_handler(e->t, map, w, &ender))
        return ender;
    if (e->t->calls[w->call].unfinished && w->end >= e->t->calls[w->call].end)
        return ender; /* nothing ended it but the run's end */
    consider(e, w, false, &ender, &fits);
    consider(e, w, true, &ender, &fits);
    return ender;
}

/* --- forwarding --- */

/* The system forwards a message before it is done with it: so the forwarded one is among the next to
 * arrive. */
enum { NEXT_ARRIVALS = 64 };

int32_t wait_enders_forwarded(const struct wait_enders *e, int32_t m)
{
    const struct trace *t = e->t;
    const struct trace_message *o = &t->messages[m];
    if (o->from == TRACE_NONE || (o->sending != TRACE_NONE && t->calls[o->sending].node == o->from))
        return TRACE_NONE;
    int32_t first = behind(e, false, o->from, o->sent ? o->sent - 1 : 0);
    for (int32_t i = first; i < t->message_count && i < first + NEXT_ARRIVALS; i++) {
        const struct trace_message *p = &t->messages[e->arriving[i]];
        if (p->to != o->from)
            break;
        bool earlier = e->arriving[i] < m && p->left <= o->sent;
        if (earlier && p->type == o->type && p->bytes == o->bytes && p->sending == o->sending)
            return e->arriving[i];
    }
    return TRACE_NONE;
}
