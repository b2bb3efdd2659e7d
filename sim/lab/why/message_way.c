/* message_way.c - see message_way.h. */
#include "lab/why/message_way.h"
#include <assert.h>
#include "kernel/xalloc.h"

/* A way under construction: all from `at` on is done. */
struct walk {
    const struct trace *t;
    struct piece_map *map;
    const struct trace_message *m;
    int32_t message;
    struct message_way *way;
    vtime at;
};

/* Adds a leg from `begin` to where the walk is. A time that the message never came to, or that is not before,
 * adds nothing. */
static void go_to(struct walk *w, vtime begin, enum why_class class, int32_t node, int32_t block)
{
    struct message_way *way = w->way;
    if (begin == VT_NEVER || begin >= w->at)
        return;
    if (way->count == way->room) {
        way->room = way->room ? 2 * way->room : 16;
        way->legs = xreallocarray(way->legs, way->room, sizeof *way->legs);
    }
    way->legs[way->count++] = (struct way_leg){begin, w->at, class, w->message, node, block};
    w->at = begin;
}

/* The system of a node has worked for the message up to now, since `from` at the earliest: it may have had to
 * finish other work first. */
static void go_through_system(struct walk *w, int32_t node, enum trace_task task, vtime from)
{
    int32_t s = node == TRACE_NONE ? TRACE_NONE : piece_map_system(w->map, node, task, w->at);
    if (s != TRACE_NONE)
        go_to(w, vt_max(from, w->t->systems[s].begin), WHY_MESSAGE, node, TRACE_NONE);
    go_to(w, from, s == TRACE_NONE ? WHY_MESSAGE : WHY_OTHER_MESSAGES, node, TRACE_NONE);
}

static void go_through_channels(struct walk *w)
{
    const struct trace_message *m = w->m;
    go_to(w, m->moved, WHY_NETWORK, TRACE_NONE, TRACE_NONE);
    for (int32_t i = m->blocks - 1; i >= 0; i--) {
        const struct trace_block *b = &w->t->blocks[m->first_block + i];
        go_to(w, b->end, WHY_NETWORK, TRACE_NONE, TRACE_NONE);
        go_to(w, vt_max(b->begin, m->entered), WHY_CHANNEL, TRACE_NONE, m->first_block + i);
    }
    go_to(w, m->entered, WHY_NETWORK, TRACE_NONE, TRACE_NONE);
}

/* Did the receiver's system answer the request as soon as it could? Otherwise the clear to send waited for
 * the receiver's program. */
static bool answered_at_once(const struct walk *w)
{
    const struct trace_message *m = w->m;
    int32_t s =
        m->to == TRACE_NONE ? TRACE_NONE : piece_map_system(w->map, m->to, TRACE_RECEIVING, m->granted);
    if (m->granted == m->asked || m->to == TRACE_NONE)
        return true;
    if (s == TRACE_NONE || w->t->systems[s].end < m->granted)
        return false;
    if (w->t->systems[s].end == m->granted)
        return true;
    /* The system works at that time, but perhaps for another message. */
    const struct trace_piece *p = piece_map_before(w->map, m->to, m->granted);
    return !p || p->call == TRACE_NONE || w->t->calls[p->call].begin < m->asked;
}

/* From the data's entry into the network back to the request. */
static void go_through_rendezvous(struct walk *w)
{
    const struct trace_message *m = w->m;
    if (m->granted == VT_NEVER || m->asked == VT_NEVER)
        return;
    int32_t s = m->from == TRACE_NONE ? TRACE_NONE : piece_map_system(w->map, m->from, TRACE_SENDING, w->at);
    if (s != TRACE_NONE)
        go_to(w, vt_max(m->granted, w->t->systems[s].begin), WHY_MESSAGE, m->from, TRACE_NONE);
    go_to(w, m->granted, WHY_NETWORK, TRACE_NONE, TRACE_NONE);
    if (answered_at_once(w))
        go_through_system(w, m->to, TRACE_RECEIVING, m->asked);
    else
        go_to(w, m->asked, WHY_GRANT, m->to, TRACE_NONE);
}

/* How far a message has come: it has entered the network, has left it, is complete at its receiver. */
enum stage { ENTERED, LEFT, COMPLETE };

static void go_back(struct walk *w, enum stage from)
{
    const struct trace_message *m = w->m;
    if (from == COMPLETE && m->left != VT_NEVER)
        go_through_system(w, m->to, TRACE_RECEIVING, m->left);
    if (from >= LEFT)
        go_through_channels(w);
    if (m->is_long)
        go_through_rendezvous(w);
    go_to(w, m->sent, WHY_NETWORK, TRACE_NONE, TRACE_NONE);
}

void message_way_find(const struct wait_enders *e, struct piece_map *map, int32_t message, bool leaves,
                      vtime at, struct message_way *way)
{
    const struct trace_message *m = &e->t->messages[message];
    struct walk w = {.t = e->t, .map = map, .way = way, .at = at, .message = message, .m = m};
    way->count = 0;
    go_back(&w, !leaves ? COMPLETE : m->is_long ? LEFT : ENTERED);
    for (;;) {
        int32_t before = wait_enders_forwarded(e, w.message);
        if (before == TRACE_NONE)
            break;
        /* The node that forwards has all of the message, and its system sends it on. */
        go_through_system(&w, w.m->from, TRACE_SENDING, e->t->messages[before].left);
        w.message = before, w.m = &e->t->messages[before];
        go_back(&w, LEFT);
    }
    assert(w.at <= at);
    way->message = w.message, way->node = w.m->from, way->sent = w.at;
}
