/* trace_pieces.c - a node's time as pieces without gap: see trace_model.h.
 *
 * What lies on top wins: a call in a handler, the handler, the call that it interrupts, computing. The
 * system's intervals cut computing and waiting: the system works for all that has come, one after the
 * other. */
#include <assert.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "lab/trace/trace_model.h"
#include "trace/recorder.h"

/* A cursor over one node. */
struct cursor {
    const struct trace *t;
    const struct trace_node *node;
    struct trace_pieces *out;
    int32_t system; /* the next that may matter */
    vtime at;       /* all before it is done */
    vtime
        owed; /* of the system's work, which has come while the program was in a call, and delays it later */
};

static void add(struct cursor *c, struct trace_piece p)
{
    struct trace_pieces *out = c->out;
    if (p.begin >= p.end)
        return;
    out->list = xgrown(out->list, out->count, sizeof *out->list);
    out->list[out->count++] = p;
}

/* Takes the system's intervals that have begun: their work is owed from now on. */
static void owe(struct cursor *c)
{
    const int32_t last = c->node->first_system + c->node->systems;
    for (; c->system < last && c->t->systems[c->system].charged <= c->at; c->system++)
        c->owed += c->t->systems[c->system].end - vt_max(c->t->systems[c->system].begin, c->t->from);
}

/* When the next interval of the system begins; not before c->at. */
static vtime next_system(const struct cursor *c)
{
    return c->system < c->node->first_system + c->node->systems ? c->t->systems[c->system].charged : VT_NEVER;
}

/* Adds `p` from c->at to `end`; what the system is owed comes first. */
static void fill(struct cursor *c, struct trace_piece p, vtime end)
{
    while (c->at < end) {
        owe(c);
        struct trace_piece q = p;
        q.begin = c->at;
        if (c->owed) {
            q.end = vt_min(end, c->at + c->owed);
            q.state = TRACE_IN_SYSTEM, q.system = c->system - 1, q.wait = TRACE_NONE;
            c->owed -= q.end - q.begin;
        } else {
            q.end = vt_min(end, next_system(c));
        }
        add(c, q);
        c->at = q.end;
    }
}

/* Adds `p` from c->at to `end`: what the system does up to `ordered` is part of it; what comes later is
 * owed. */
static void fill_whole(struct cursor *c, struct trace_piece p, vtime end, vtime ordered)
{
    if (c->at >= end)
        return;
    p.begin = c->at, p.end = end;
    add(c, p);
    c->at = vt_min(ordered, end);
    owe(c);
    c->owed = 0;
    c->at = end;
    owe(c);
}

/* What the program does between c->at and `end`, in a handler or outside. */
static void compute_until(struct cursor *c, vtime end, int32_t handler)
{
    fill(c,
         (struct trace_piece){.state = TRACE_COMPUTING,
                              .in_handler = handler != TRACE_NONE,
                              .call = TRACE_NONE,
                              .wait = TRACE_NONE,
                              .handler = handler,
                              .system = TRACE_NONE},
         end);
}

/* Does the call stand for the time without a program? */
static bool is_absent(const struct trace *t, const struct trace_call *call)
{
    return !strcmp(t->names[call->name], RECORDER_NO_PROGRAM);
}

static void ended_until(struct cursor *c, vtime end)
{
    fill_whole(c,
               (struct trace_piece){.state = TRACE_ENDED,
                                    .call = TRACE_NONE,
                                    .wait = TRACE_NONE,
                                    .handler = TRACE_NONE,
                                    .system = TRACE_NONE},
               end, end);
}

/* Inserts a piece of the system behind piece i of a wait, for the last `length` of it. */
static void split_wait(struct trace_pieces *out, size_t i, vtime length)
{
    struct cursor room = {.out = out};
    add(&room, out->list[out->count - 1]);
    for (size_t k = out->count - 1; k > i + 1; k--)
        out->list[k] = out->list[k - 1];
    out->list[i + 1] = out->list[i];
    out->list[i].end -= length;
    out->list[i + 1].begin = out->list[i].end;
    out->list[i + 1].state = TRACE_IN_SYSTEM, out->list[i + 1].wait = TRACE_NONE;
}

/* Has the pieces of a wait, those from `first` on, rest for the wait's idle time. The run counts all work
 * that came in the wait, also such as runs beside other work, or is not done when the wait ends: what the
 * system's intervals do not cover of it stands before them, so that the wait still ends when it did. */
static void settle(struct cursor *c, size_t first, int32_t wait)
{
    struct trace_pieces *out = c->out;
    const vtime idle = c->t->waits[wait].idle;
    vtime rests = 0;
    for (size_t i = first; i < out->count; i++)
        if (out->list[i].state == TRACE_WAITING)
            rests += out->list[i].end - out->list[i].begin;
    for (size_t i = out->count; i-- > first && rests > idle;) {
        struct trace_piece *p = &out->list[i];
        vtime length = vt_min(p->end - p->begin, rests - idle);
        if (p->state != TRACE_WAITING)
            continue;
        rests -= length;
        if (length < p->end - p->begin)
            split_wait(out, i, length);
        else
            p->state = TRACE_IN_SYSTEM, p->wait = TRACE_NONE;
    }
    for (size_t i = first; i < out->count && rests < idle; i++) {
        struct trace_piece *p = &out->list[i];
        vtime length = p->end - p->begin;
        if (p->state != TRACE_IN_SYSTEM)
            continue;
        if (length > idle - rests) {
            split_wait(out, i, length - (idle - rests));
            p = &out->list[i], length = idle - rests;
        }
        rests += length;
        p->state = TRACE_WAITING, p->wait = wait, p->system = TRACE_NONE;
    }
}

/* The call's own part up to `end`: its waits, and the system between them. */
static void call_until(struct cursor *c, const struct trace_call *call, vtime end, int32_t handler,
                       int32_t *wait)
{
    const struct trace *t = c->t;
    struct trace_piece p = {.in_handler = handler != TRACE_NONE,
                            .call = (int32_t)(call - t->calls),
                            .wait = TRACE_NONE,
                            .handler = handler,
                            .system = TRACE_NONE};
    if (is_absent(t, call)) {
        ended_until(c, end);
        return;
    }
    for (; c->at < end;) {
        while (*wait < call->first_wait + call->waits && t->waits[*wait].end <= c->at)
            ++*wait;
        const struct trace_wait *w = *wait < call->first_wait + call->waits ? &t->waits[*wait] : NULL;
        bool waits = w && w->begin <= c->at;
        p.state = waits ? TRACE_WAITING : TRACE_IN_CALL;
        p.wait = waits ? *wait : TRACE_NONE;
        vtime stop = w ? vt_min(end, waits ? w->end : w->begin) : end;
        bool whole = waits && w->begin == c->at && w->end == stop;
        size_t first = c->out->count;
        if (w)
            fill(c, p, stop);
        else
            fill_whole(c, p, stop, call->ordered);
        if (whole)
            settle(c, first, *wait);
        if (waits) { /* what the system still has to do does not hold up the program */
            owe(c);
            c->owed = 0;
        }
    }
}

/* The system's part of a handler, before or behind the program's. */
static void enter_or_leave(struct cursor *c, int32_t handler, vtime end)
{
    fill_whole(c,
               (struct trace_piece){.state = TRACE_IN_SYSTEM,
                                    .in_handler = true,
                                    .call = TRACE_NONE,
                                    .wait = TRACE_NONE,
                                    .handler = handler,
                                    .system = TRACE_NONE},
               vt_min(end, c->t->to), 0);
}

/* The handler's time, up to its end: its calls come next in the table. */
static void in_handler(struct cursor *c, int32_t handler, int32_t *call)
{
    const struct trace *t = c->t;
    const struct trace_handler *h = &t->handlers[handler];
    const int32_t last = c->node->first_call + c->node->calls;
    enter_or_leave(c, handler, h->entered);
    for (; *call < last && t->calls[*call].in_handler && t->calls[*call].begin < h->end; ++*call) {
        const struct trace_call *k = &t->calls[*call];
        int32_t wait = k->first_wait;
        compute_until(c, vt_min(k->begin, t->to), handler);
        call_until(c, k, vt_min(k->end, t->to), handler, &wait);
    }
    compute_until(c, vt_min(h->left, t->to), handler);
    enter_or_leave(c, handler, h->end);
}

/* The end of what is known of the node. */
static vtime end_of(const struct cursor *c)
{
    return vt_min(c->node->end, c->t->to);
}

/* Runs the handlers that begin before `end`, and what the program does between them: in call k (NULL: it
 * computes). */
static void until(struct cursor *c, const struct trace_call *k, vtime end, int32_t *handler, int32_t *call)
{
    const struct trace *t = c->t;
    const int32_t last = c->node->first_handler + c->node->handlers;
    int32_t wait = k ? k->first_wait : 0;
    end = vt_min(end, end_of(c));
    for (bool more = true; more;) {
        more = *handler < last && t->handlers[*handler].begin < end;
        vtime stop = more ? vt_max(c->at, t->handlers[*handler].begin) : end;
        if (k)
            call_until(c, k, stop, TRACE_NONE, &wait);
        else
            compute_until(c, stop, TRACE_NONE);
        if (more)
            in_handler(c, (*handler)++, call);
    }
}

void trace_pieces(const struct trace *t, int32_t node, struct trace_pieces *p)
{
    const struct trace_node *n = &t->nodes[node];
    struct cursor c = {.t = t, .node = n, .out = p, .system = n->first_system, .at = t->from};
    int32_t handler = n->first_handler;
    for (int32_t call = n->first_call; n->traced && call < n->first_call + n->calls;) {
        const struct trace_call *k = &t->calls[call];
        if (k->in_handler &&
            (handler == n->first_handler + n->handlers || t->handlers[handler].begin > k->begin)) {
            call++; /* its handler is not in the trace */
            continue;
        }
        until(&c, NULL, k->in_handler ? t->handlers[handler].end : k->begin, &handler, &call);
        if (t->calls + call != k)
            continue; /* handlers on the way have made calls */
        call++;
        until(&c, k, k->end, &handler, &call);
    }
    if (n->traced)
        until(&c, NULL, end_of(&c), &handler, &(int32_t){n->first_call + n->calls});
    ended_until(&c, t->to);
}

const char *trace_state_name(enum trace_state s)
{
    static const char *const NAMES[] = {"computing", "in a call", "waiting", "in the system", "ended"};
    assert(s < TRACE_STATES);
    return NAMES[s];
}
