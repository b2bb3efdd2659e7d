/* timeline.c - see timeline.h. Calls, handlers and pieces of a node are three lists in order of time; a walk
 * merges them and keeps a stack of the slices that are open. */
#include "lab/export/timeline.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

enum { DEEPEST = 64 };

/* --- who sent and took which messages --- */

static int32_t *none_of(int32_t count)
{
    int32_t *list = xmalloc((size_t)(count + 1) * sizeof *list);
    for (int32_t i = 0; i < count; i++)
        list[i] = TRACE_NONE;
    return list;
}

/* Keeps a call's messages in order of the time at which it took them. */
static void add_taken(struct timeline *l, int32_t message)
{
    const struct trace_message *all = l->trace->messages, *m = &all[message];
    int32_t *at = &l->first_taken[m->taking];
    while (*at != TRACE_NONE && all[*at].taken < m->taken)
        at = &l->next_taken[*at];
    l->next_taken[message] = *at;
    *at = message;
}

/* Messages are sorted by the time of sending: so are those of a call. */
static void add_sent(struct timeline *l, int32_t message)
{
    int32_t *first = &l->first_sent[l->trace->messages[message].sending];
    l->next_sent[message] = *first;
    *first = message;
}

static void add_handlers(struct timeline *l)
{
    const struct trace *t = l->trace;
    for (int32_t i = 0; i < t->handler_count; i++) {
        const struct trace_handler *h = &t->handlers[i];
        if (h->message == TRACE_NONE)
            continue;
        const struct trace_message *m = &t->messages[h->message];
        if (m->to == h->node && m->taking == TRACE_NONE) /* a handler of hsend is run for the sender */
            l->handler[h->message] = i;
    }
}

struct timeline timeline_of(const struct trace *t)
{
    struct timeline l = {.trace = t,
                         .first_sent = none_of(t->call_count),
                         .next_sent = none_of(t->message_count),
                         .first_taken = none_of(t->call_count),
                         .next_taken = none_of(t->message_count),
                         .handler = none_of(t->message_count)};
    for (int32_t i = t->message_count; i-- > 0;) {
        if (t->messages[i].sending != TRACE_NONE)
            add_sent(&l, i);
        if (t->messages[i].taking != TRACE_NONE)
            add_taken(&l, i);
    }
    add_handlers(&l);
    return l;
}

void timeline_free(struct timeline *l)
{
    free(l->first_sent);
    free(l->next_sent);
    free(l->first_taken);
    free(l->next_taken);
    free(l->handler);
}

int32_t timeline_sender(const struct timeline *l, int32_t message)
{
    const struct trace_message *m = &l->trace->messages[message];
    return m->sending == TRACE_NONE ? m->from : l->trace->calls[m->sending].node;
}

bool timeline_has_ends(const struct timeline *l, int32_t message)
{
    const struct trace_message *m = &l->trace->messages[message];
    return m->sending != TRACE_NONE && (m->taking != TRACE_NONE || l->handler[message] != TRACE_NONE);
}

/* --- names --- */

const char *timeline_name(const struct trace *t, const struct timeline_slice *s)
{
    static const char *const SYSTEM[] = {
        [TRACE_SENDING] = "system: sending",
        [TRACE_RECEIVING] = "system: receiving",
        [TRACE_FEEDING] = "system: feeding",
        [TRACE_EMPTYING] = "system: emptying",
    };
    switch (s->kind) {
    case TIMELINE_COMPUTING:
        return "computing";
    case TIMELINE_WAITING:
        return "waiting";
    case TIMELINE_SYSTEM:
        return s->index == TRACE_NONE ? "system" : SYSTEM[t->systems[s->index].task];
    case TIMELINE_CALL:
    case TIMELINE_LIBRARY:
        return t->names[t->calls[s->index].name];
    case TIMELINE_HANDLER:
        break;
    }
    return "handler";
}

/* --- a walk --- */

/* A slice that is open, and the ends of messages in it that are still to come. */
struct open {
    struct timeline_slice slice;
    int32_t sent, taken; /* the first of them */
};

struct walk {
    const struct timeline *l;
    const struct timeline_visitor *visit;
    void *ctx;
    const struct trace_node *node;
    struct trace_pieces pieces;
    int32_t call, handler; /* the next of the node's */
    int32_t library;       /* the call before which a slice of MPI's was entered last */
    size_t piece;
    struct open stack[DEEPEST];
    int depth;
};

vtime timeline_within(const struct trace *t, vtime time)
{
    return vt_min(vt_max(time, t->from), t->to);
}

static vtime clamped(const struct timeline_slice *s, vtime time)
{
    return vt_min(vt_max(time, s->begin), s->end);
}

/* The next end of a message in the slice. False: there is none. */
static bool next_end(const struct walk *w, const struct open *o, struct timeline_end *e)
{
    const struct trace_message *all = w->l->trace->messages;
    vtime sent = o->sent != TRACE_NONE ? clamped(&o->slice, all[o->sent].sent) : VT_NEVER;
    vtime taken = VT_NEVER;
    if (o->taken != TRACE_NONE) /* before a handler is run, the message is in the program's memory */
        taken = o->slice.kind == TIMELINE_CALL ? clamped(&o->slice, all[o->taken].taken) : o->slice.begin;
    if (sent == VT_NEVER && taken == VT_NEVER)
        return false;
    *e = (struct timeline_end){.taken = taken < sent,
                               .at = vt_min(sent, taken),
                               .message = taken < sent ? o->taken : o->sent,
                               .call = o->slice.kind == TIMELINE_CALL ? o->slice.index : TRACE_NONE};
    return true;
}

static void show_end(struct walk *w, struct open *o, const struct timeline_end *e)
{
    if (e->taken)
        o->taken = o->slice.kind == TIMELINE_CALL ? w->l->next_taken[e->message] : TRACE_NONE;
    else
        o->sent = w->l->next_sent[e->message];
    if (w->visit->message)
        w->visit->message(w->ctx, e);
}

/* Shows the ends of messages up to a time, of all open slices. */
static void show_ends(struct walk *w, vtime until)
{
    for (;;) {
        struct open *earliest = NULL;
        struct timeline_end first = {.at = VT_NEVER}, e;
        for (struct open *o = w->stack; o < w->stack + w->depth; o++)
            if (next_end(w, o, &e) && e.at <= until && e.at < first.at)
                earliest = o, first = e;
        if (!earliest)
            return;
        show_end(w, earliest, &first);
    }
}

/* Closes the slices that end until then. */
static void close_until(struct walk *w, vtime until)
{
    while (w->depth > 0 && w->stack[w->depth - 1].slice.end <= until) {
        struct open *o = &w->stack[w->depth - 1];
        show_ends(w, o->slice.end);
        w->depth--;
        if (w->visit->leave)
            w->visit->leave(w->ctx, &o->slice);
    }
    show_ends(w, until);
}

static struct open opened(const struct timeline *l, const struct timeline_slice *s)
{
    struct open o = {*s, TRACE_NONE, TRACE_NONE};
    if (s->kind == TIMELINE_CALL) {
        o.sent = l->first_sent[s->index];
        o.taken = l->first_taken[s->index];
    } else if (s->kind == TIMELINE_HANDLER) {
        int32_t m = l->trace->handlers[s->index].message;
        if (m != TRACE_NONE && l->handler[m] == s->index)
            o.taken = m;
    }
    return o;
}

static void enter(struct walk *w, struct timeline_slice s)
{
    close_until(w, s.begin);
    if (w->depth == DEEPEST)
        return;
    if (w->depth > 0)
        s.end = vt_min(s.end, w->stack[w->depth - 1].slice.end);
    w->stack[w->depth++] = opened(w->l, &s);
    if (w->visit->enter)
        w->visit->enter(w->ctx, &s);
}

/* The end of a call or handler that may not have come to it. */
static vtime end_of(const struct trace *t, const struct trace_node *n, vtime begin, vtime end,
                    bool unfinished)
{
    return vt_max(begin, timeline_within(t, unfinished ? vt_min(end, n->end) : end));
}

static struct timeline_slice next_call(const struct walk *w)
{
    const struct trace *t = w->l->trace;
    if (w->call == w->node->first_call + w->node->calls)
        return (struct timeline_slice){.begin = VT_NEVER};
    const struct trace_call *c = &t->calls[w->call];
    vtime begin = timeline_within(t, c->begin);
    return (struct timeline_slice){TIMELINE_CALL, begin, end_of(t, w->node, begin, c->end, c->unfinished),
                                   w->call};
}

/* A call of MPI that goes around the next call and others behind it. False: there is none. */
static bool next_library(const struct walk *w, const struct timeline_slice *call,
                         struct timeline_slice *library)
{
    const struct trace *t = w->l->trace;
    int32_t last = w->call, end = w->node->first_call + w->node->calls, shown = TRACE_NONE;
    if (w->library == w->call || t->calls[w->call].continues)
        return false;
    for (int32_t i = w->call; i < end; i++) {
        if (i > w->call && !t->calls[i].continues && !t->calls[i].in_handler)
            break;
        last = t->calls[i].continues ? i : last;
        if (shown == TRACE_NONE && trace_place(t, t->calls[i].stack))
            shown = i;
    }
    const struct trace_call *c = &t->calls[last];
    *library = *call;
    library->kind = TIMELINE_LIBRARY;
    library->index = shown == TRACE_NONE ? w->call : shown;
    library->end = end_of(t, w->node, call->begin, c->end, c->unfinished);
    return last > w->call;
}

static struct timeline_slice next_handler(const struct walk *w)
{
    const struct trace *t = w->l->trace;
    if (w->handler == w->node->first_handler + w->node->handlers)
        return (struct timeline_slice){.begin = VT_NEVER};
    const struct trace_handler *h = &t->handlers[w->handler];
    vtime begin = timeline_within(t, h->begin);
    return (struct timeline_slice){TIMELINE_HANDLER, begin, end_of(t, w->node, begin, h->end, h->unfinished),
                                   w->handler};
}

/* A piece that is a slice: the work for a call is the rest of that call's. */
static bool is_slice(const struct trace_piece *p)
{
    return p->state == TRACE_COMPUTING || p->state == TRACE_WAITING || p->state == TRACE_IN_SYSTEM;
}

static struct timeline_slice next_piece(struct walk *w)
{
    while (w->piece < w->pieces.count && !is_slice(&w->pieces.list[w->piece]))
        w->piece++;
    if (w->piece == w->pieces.count)
        return (struct timeline_slice){.begin = VT_NEVER};
    const struct trace_piece *p = &w->pieces.list[w->piece];
    struct timeline_slice s = {TIMELINE_COMPUTING, p->begin, p->end, TRACE_NONE};
    if (p->state == TRACE_WAITING)
        s.kind = TIMELINE_WAITING, s.index = p->wait;
    else if (p->state == TRACE_IN_SYSTEM)
        s.kind = TIMELINE_SYSTEM, s.index = p->system;
    return s;
}

/* Of a call and a handler that begin at the same time: does the call go around the handler? */
static bool call_first(const struct trace *t, const struct timeline_slice *call,
                       const struct timeline_slice *handler)
{
    if (call->begin != handler->begin)
        return call->begin < handler->begin;
    if (call->end != handler->end)
        return call->end > handler->end;
    return !t->calls[call->index].in_handler;
}

/* Enters the next slice. False: there is none. */
static bool step(struct walk *w)
{
    struct timeline_slice call = next_call(w), handler = next_handler(w), piece = next_piece(w);
    vtime first = vt_min(vt_min(call.begin, handler.begin), piece.begin);
    if (first == VT_NEVER)
        return false;
    if (piece.begin == first && call.begin != first && handler.begin != first) {
        w->piece++;
        enter(w, piece);
    } else if (handler.begin == VT_NEVER ||
               (call.begin != VT_NEVER && call_first(w->l->trace, &call, &handler))) {
        struct timeline_slice library;
        if (next_library(w, &call, &library)) {
            w->library = w->call;
            enter(w, library);
            return true;
        }
        w->call++;
        enter(w, call);
    } else {
        w->handler++;
        enter(w, handler);
    }
    return true;
}

void timeline_walk(const struct timeline *l, int32_t node, const struct timeline_visitor *visit, void *ctx)
{
    const struct trace_node *n = &l->trace->nodes[node];
    struct walk w = {.l = l,
                     .visit = visit,
                     .ctx = ctx,
                     .node = n,
                     .call = n->first_call,
                     .handler = n->first_handler,
                     .library = TRACE_NONE};
    if (!n->traced)
        return;
    trace_pieces(l->trace, node, &w.pieces);
    while (step(&w))
        ;
    close_until(&w, VT_NEVER - 1);
    free(w.pieces.list);
}
