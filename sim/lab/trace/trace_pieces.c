/* trace_pieces.c - a node's time as pieces without gap: see trace_model.h.
 *
 * What lies on top wins: a call in a handler, the handler, the call that it interrupts, computing. Within the top, the
 * system's intervals cut computing and waiting. */
#include <assert.h>
#include "kernel/xalloc.h"
#include "lab/trace/trace_model.h"

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
    if (out->count == out->room) {
        out->room = out->room ? 2 * out->room : 64;
        out->list = xreallocarray(out->list, out->room, sizeof *out->list);
    }
    out->list[out->count++] = p;
}

/* The first system interval that does not end before c->at; NULL: none. */
static const struct trace_system *system_at(struct cursor *c)
{
    const int32_t last = c->node->first_system + c->node->systems;
    while (c->system < last && c->t->systems[c->system].end <= c->at)
        c->system++;
    return c->system < last ? &c->t->systems[c->system] : NULL;
}

/* The system's work between c->at and `end`, which takes no time of what the program does there, is owed. */
static void owe(struct cursor *c, vtime end)
{
    for (const struct trace_system *s; (s = system_at(c)) && s->begin < end; c->system++) {
        c->owed += vt_min(s->end, end) - vt_max(s->begin, c->at);
        if (s->end > end)
            break;
    }
    c->at = end;
}

/* Adds an interval of the system from c->at to `end`: of interval number `system`. */
static void add_system(struct cursor *c, struct trace_piece p, vtime end, int32_t system)
{
    p.begin = c->at, p.end = end;
    p.state = TRACE_IN_SYSTEM, p.system = system, p.wait = TRACE_NONE;
    add(c, p);
}

/* Adds the system's part of what is owed: meanwhile more may come. */
static void pay(struct cursor *c, struct trace_piece p, vtime end)
{
    while (c->owed && c->at < end) {
        vtime until = vt_min(end, c->at + c->owed);
        int32_t last = c->node->first_system + c->node->systems - 1;
        add_system(c, p, until, c->system < last ? c->system : last);
        c->owed -= until - c->at;
        owe(c, until);
    }
}

/* Adds `p` from c->at to `end`, cut by the system's intervals. */
static void fill(struct cursor *c, struct trace_piece p, vtime end)
{
    pay(c, p, end);
    while (c->at < end) {
        const struct trace_system *s = system_at(c);
        vtime until = end;
        if (s && s->begin <= c->at) {
            until = vt_min(end, s->end);
            add_system(c, p, until, c->system);
        } else {
            until = s ? vt_min(end, s->begin) : end;
            p.begin = c->at, p.end = until;
            add(c, p);
        }
        c->at = until;
    }
}

/* Adds `p`, which the system's intervals do not cut: they cut what follows. */
static void fill_whole(struct cursor *c, struct trace_piece p, vtime end)
{
    if (c->at >= end)
        return;
    p.begin = c->at, p.end = end;
    add(c, p);
    owe(c, end);
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
    for (; c->at < end;) {
        while (*wait < call->first_wait + call->waits && t->waits[*wait].end <= c->at)
            ++*wait;
        const struct trace_wait *w = *wait < call->first_wait + call->waits ? &t->waits[*wait] : NULL;
        bool waits = w && w->begin <= c->at;
        p.state = waits ? TRACE_WAITING : TRACE_IN_CALL;
        p.wait = waits ? *wait : TRACE_NONE;
        vtime stop = w ? vt_min(end, waits ? w->end : w->begin) : end;
        if (waits)
            fill(c, p, stop);
        else
            fill_whole(c, p, stop);
    }
}

static void ended_until(struct cursor *c, vtime end)
{
    fill_whole(c,
               (struct trace_piece){.state = TRACE_ENDED,
                                    .call = TRACE_NONE,
                                    .wait = TRACE_NONE,
                                    .handler = TRACE_NONE,
                                    .system = TRACE_NONE},
               end);
}

/* The handler's time, up to its end: its calls come next in the table. */
static void in_handler(struct cursor *c, int32_t handler, int32_t *call)
{
    const struct trace *t = c->t;
    const struct trace_handler *h = &t->handlers[handler];
    const int32_t last = c->node->first_call + c->node->calls;
    for (; *call < last && t->calls[*call].in_handler && t->calls[*call].begin < h->end; ++*call) {
        const struct trace_call *k = &t->calls[*call];
        int32_t wait = k->first_wait;
        compute_until(c, vt_min(k->begin, t->to), handler);
        call_until(c, k, vt_min(k->end, t->to), handler, &wait);
    }
    compute_until(c, vt_min(h->end, t->to), handler);
}

/* The end of what is known of the node. */
static vtime end_of(const struct cursor *c)
{
    return vt_min(c->node->end, c->t->to);
}

/* Runs the handlers that begin before `end`, and what the program does between them: in call k (NULL: it computes). */
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
