/* critical_path.c - see critical_path.h. */
#include "lab/why/critical_path.h"
#include <assert.h>
#include <stdlib.h>
#include "kernel/xalloc.h"

/* A path under construction: all from `at` on is done. */
struct walk {
    const struct trace *t;
    struct piece_map *map;
    const struct wait_enders *enders;
    struct path path;
    struct message_way way;
    int32_t node;
    vtime at;
    int32_t inside; /* the handler that sent the message along which the walk came; TRACE_NONE */
    struct {
        int32_t message; /* TRACE_NONE: nothing is due */
        vtime at;        /* when the message made the handler due that the walk has come through */
    } due;
    int32_t jumps_here;           /* since `at` has changed */
    struct trace_around **around; /* by node: of its pieces; NULL: not found yet */
};

/* --- steps --- */

static void add(struct walk *w, vtime begin, struct path_step step)
{
    struct path *p = &w->path;
    begin = vt_max(begin, w->t->from);
    if (begin >= w->at)
        return;
    p->steps = xgrown(p->steps, p->count, sizeof *p->steps);
    step.begin = begin, step.end = w->at;
    p->steps[p->count++] = step;
    w->at = begin;
    w->jumps_here = 0;
}

static struct path_step step_of(enum why_class class, int32_t node)
{
    return (struct path_step){.class = class,
                              .node = node,
                              .call = TRACE_NONE,
                              .handler = TRACE_NONE,
                              .message = TRACE_NONE,
                              .block = TRACE_NONE,
                              .stack = TRACE_NONE,
                              .before = TRACE_NONE,
                              .seen = TRACE_NONE};
}

static enum why_class class_of(const struct trace_piece *p)
{
    switch (p->state) {
    case TRACE_COMPUTING:
        return p->in_handler ? WHY_HANDLERS : WHY_COMPUTING;
    case TRACE_IN_CALL:
        return p->in_handler ? WHY_HANDLERS : WHY_CALLS;
    case TRACE_IN_SYSTEM:
        return piece_enters_handler(p) ? WHY_HANDLERS : WHY_OTHER_MESSAGES;
    case TRACE_WAITING:
        return WHY_WAITING;
    default:
        return WHY_ABSENT;
    }
}

/* Where the program was around a piece of the walk's node. Found for all pieces of a node at once: many
 * handlers may lie between a call and a piece. */
static const struct trace_around *around(struct walk *w, const struct trace_piece *p)
{
    const struct trace_pieces *all = piece_map_of(w->map, w->node);
    struct trace_around **found = &w->around[w->node];
    if (!*found) {
        *found = xcalloc(all->count + 1, sizeof **found);
        trace_around(w->t, all->list, all->count, *found);
    }
    return &(*found)[p - all->list];
}

/* Goes back over the piece in which the walk is, to `least` at the earliest. */
static void over_piece(struct walk *w, vtime least)
{
    const struct trace_piece *p = piece_map_before(w->map, w->node, w->at);
    assert(p);
    struct path_step s = step_of(class_of(p), w->node);
    s.call = p->call;
    s.handler = p->in_handler ? p->handler : TRACE_NONE;
    s.enters_handler = piece_enters_handler(p);
    s.stack = around(w, p)->after;
    if (p->state == TRACE_COMPUTING)
        s.before = around(w, p)->before, s.seen = around(w, p)->seen;
    add(w, vt_max(p->begin, least), s);
}

/* Has the walk come to the beginning of the handler from which it came? Then the message counts that made the
 * handler due. */
static void leave_handler(struct walk *w)
{
    const struct trace_handler *h = w->inside == TRACE_NONE ? NULL : &w->t->handlers[w->inside];
    if (!h || w->at > h->begin)
        return;
    w->inside = TRACE_NONE;
    if (h->message != TRACE_NONE && h->due <= w->at) {
        w->due.message = h->message;
        w->due.at = h->due;
    }
}

/* --- jumps --- */

/* Goes on at a node, where the program did at `at` what counts. */
static void go_on_at(struct walk *w, int32_t node)
{
    w->path.jumps += node != w->node;
    w->node = node;
    w->due.message = w->inside = TRACE_NONE;
    const struct trace_piece *p = piece_map_before(w->map, node, w->at);
    if (p && p->in_handler)
        w->inside = p->handler;
}

/* Jumps along a message that has arrived (or left) now. `call` is the call that waited for it, or
 * TRACE_NONE. */
static void along_message(struct walk *w, int32_t message, bool leaves, int32_t call)
{
    w->jumps_here++;
    message_way_find(w->enders, w->map, message, leaves, w->at, &w->way);
    for (size_t i = 0; i < w->way.count; i++) {
        const struct way_leg *leg = &w->way.legs[i];
        if (leg->class == WHY_GRANT && leg->node != TRACE_NONE && w->t->nodes[leg->node].traced) {
            go_on_at(w, leg->node);
            return;
        }
        struct path_step s = step_of(leg->class, leg->node);
        s.message = leg->message, s.block = leg->block, s.call = call;
        add(w, leg->begin, s);
    }
    int32_t sender = w->way.node;
    go_on_at(w, sender == TRACE_NONE || !w->t->nodes[sender].traced ? w->node : sender);
}

/* Goes back over a whole wait of which no more is known. */
static void over_wait(struct walk *w, const struct trace_wait *wait)
{
    const struct trace_call *c = &w->t->calls[wait->call];
    struct path_step s = step_of(w->t->classes[c->name] == TRACE_FILES ? WHY_FILES : WHY_WAITING, w->node);
    s.call = wait->call, s.stack = c->stack;
    add(w, wait->begin, s);
}

/* The walk stands at the end of a wait. */
static void from_wait(struct walk *w, int32_t wait)
{
    const struct trace_wait *x = &w->t->waits[wait];
    struct wait_ender e = wait_enders_of(w->enders, w->map, wait);
    if (e.message == TRACE_NONE || w->t->messages[e.message].from == TRACE_NONE) {
        over_wait(w, x);
        return;
    }
    while (w->at > e.at && w->at > w->t->from)
        over_piece(w, e.at);
    if (w->at > w->t->from)
        along_message(w, e.message, e.leaves, x->call);
}

/* The wait that ends where the walk is, if any: the walk has come back to its end. */
static int32_t wait_ending_here(const struct walk *w, const struct trace_piece *p)
{
    if (p->state != TRACE_WAITING && p->state != TRACE_IN_SYSTEM)
        return TRACE_NONE;
    int32_t wait = piece_map_wait(w->map, p, w->at);
    return wait != TRACE_NONE && w->t->waits[wait].end == w->at ? wait : TRACE_NONE;
}

/* A message that was here before it made its handler due lay there until the program posted the receive: then
 * the program counts. */
static void go_back(struct walk *w)
{
    leave_handler(w);
    /* Events of one time may lead in a circle, since their order is not in the trace. */
    bool may_jump = w->jumps_here <= w->t->node_count;
    if (!may_jump)
        w->due.message = TRACE_NONE;
    if (w->due.message != TRACE_NONE && w->at <= w->due.at) {
        const struct trace_message *m = &w->t->messages[w->due.message];
        if (m->to == w->node && m->complete < w->due.at) {
            go_on_at(w, w->node);
            return;
        }
        bool leaves = m->to != w->node || m->complete != w->due.at;
        along_message(w, w->due.message, leaves, TRACE_NONE);
        return;
    }
    const struct trace_piece *p = piece_map_before(w->map, w->node, w->at);
    assert(p);
    int32_t wait = may_jump ? wait_ending_here(w, p) : TRACE_NONE;
    if (wait != TRACE_NONE)
        from_wait(w, wait);
    else
        over_piece(w, w->due.message != TRACE_NONE ? w->due.at : w->t->from);
}

/* --- the whole path --- */

/* The node that ended last. */
static int32_t last_node(const struct trace *t)
{
    int32_t last = 0;
    for (int32_t i = 1; i < t->node_count; i++)
        if (t->nodes[i].traced && (!t->nodes[last].traced || t->nodes[i].end > t->nodes[last].end))
            last = i;
    return last;
}

static void reverse(struct path *p)
{
    for (size_t i = 0; i < p->count / 2; i++) {
        struct path_step s = p->steps[i];
        p->steps[i] = p->steps[p->count - 1 - i];
        p->steps[p->count - 1 - i] = s;
    }
}

/* The promise of critical_path.h. */
static void check(const struct trace *t, const struct path *p)
{
    vtime at = t->from;
    for (size_t i = 0; i < p->count; i++) {
        assert(p->steps[i].begin == at && p->steps[i].end > at);
        at = p->steps[i].end;
    }
    assert(at == t->to);
    (void)at;
}

struct path path_find(const struct trace *t, struct piece_map *map, const struct wait_enders *enders)
{
    struct walk w = {.t = t,
                     .map = map,
                     .enders = enders,
                     .node = last_node(t),
                     .at = t->to,
                     .inside = TRACE_NONE,
                     .due = {TRACE_NONE, 0},
                     .around = xcalloc((size_t)t->node_count, sizeof *w.around)};
    while (w.at > t->from)
        go_back(&w);
    reverse(&w.path);
    check(t, &w.path);
    for (int32_t i = 0; i < t->node_count; i++)
        free(w.around[i]);
    free(w.around);
    free(w.way.legs);
    return w.path;
}
