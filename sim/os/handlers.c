/* handlers.c - the handlers of a node: those of hrecv, hsend and their kin. One that is due runs on its program's stack, where the
 * program can be interrupted: between two parts of its computing, or in a call; not inside of another. See handlers.h. */
#include "os/handlers.h"
#include <stdlib.h>
#include "lp/clock.h"
#include "lp/engine.h"
#include "os/match.h"
#include "node/system.h"
#include "os/fail.h"
#include "os/front.h"
#include "os/gate.h"

/* A handler that is to run: for a receive that is complete, or a send whose buffer is free. */
struct due {
    vtime at;
    struct receive *receive;
    struct send *send;
    struct due *next;
};

static const struct due *first_due(const struct mailbox *b)
{
    return b->last_due ? b->last_due->next : NULL;
}

static struct due take_due(struct mailbox *b)
{
    struct due *first = b->last_due->next, d = *first;
    b->last_due->next = first->next;
    if (b->last_due == first)
        b->last_due = NULL;
    free(first);
    return d;
}

void handlers_free(struct mailbox *b)
{
    while (b->last_due) {
        struct due d = take_due(b);
        if (d.receive && d.receive->m)
            protocol_message_free(d.receive->m);
        free(d.receive);
        free(d.send);
    }
}

void handlers_add(struct node *n, vtime at, struct receive *r, struct send *s)
{
    lp_synchronise(&n->lp);
    struct mailbox *b = &n->mailbox;
    struct due *d = calloc(1, sizeof *d);
    if (!d)
        abort();
    *d = (struct due){.at = at, .receive = r, .send = s, .next = d};
    if (b->last_due)
        d->next = b->last_due->next, b->last_due->next = d;
    b->last_due = d;
    lp_wake(&n->lp, at);
}

void mailbox_post_handler(struct node *n, const struct receive *what)
{
    struct receive *r = calloc(1, sizeof *r);
    if (!r)
        abort();
    *r = *what;
    n->mailbox.handlers++;
    n->armed = true;
    mailbox_post(n, r);
}

struct send *mailbox_send_handler(struct node *n, mailbox_handler *handler, long param)
{
    struct send *s = calloc(1, sizeof *s);
    if (!s)
        abort();
    s->handler = handler, s->param = param;
    n->mailbox.handlers++;
    n->armed = true;
    return s;
}

bool handlers_armed(const struct node *n)
{
    return n->mailbox.handlers > 0 && !n->masked && !n->in_handler;
}

vtime handlers_next_due(const struct node *n)
{
    const struct due *first = first_due(&n->mailbox);
    return first ? vt_max(first->at, clock_when(&n->lp, n->share_until)) : VT_NEVER;
}

bool handlers_due(const struct node *n, vtime now)
{
    const struct due *first = first_due(&n->mailbox);
    return first && first->at <= now && !n->masked && !n->in_handler;
}

/* Handlers are let run from now on. */
void handlers_open(struct node *n)
{
    n->opened.at = node_now(n);
    n->opened.units = n->lp.clock.units;
}

/* By how much a handler is late that was due at a time: none if its program has done nothing since handlers were let run, else
 * from then on at most. */
static vtime delay(struct node *n, vtime due)
{
    vtime now = node_now(n), from = vt_max(due, n->opened.at);
    return n->lp.clock.units == n->opened.units || from > now ? 0 : now - from;
}

/* The first that is due. */
static void run_first(struct node *n)
{
    struct mailbox *b = &n->mailbox;
    struct due d = take_due(b);
    struct node_info before = n->info;
    b->handlers--;
    n->stats.handlers++;
    n->stats.latest = vt_max(n->stats.latest, delay(n, d.at));
    n->in_handler = true;

    mailbox_handler *handler = d.receive ? d.receive->handler : d.send->handler;
    long param = d.receive ? d.receive->param : d.send->param;
    node_spend_on(n, NODE_INTERRUPT, n->sys->cfg->interrupt_ps / 2);
    if (!d.receive)
        n->info = d.send->info;
    else if (mailbox_take(n, d.receive) < 0)
        node_fail(n, "hrecv: %s", n->error->text);
    free(d.receive);
    free(d.send);
    node_leave(n);
    handler(n->info.type, n->info.count, n->info.node, n->info.pid, param);
    node_enter(n, "(the end of a handler)");
    node_spend_on(n, NODE_INTERRUPT, n->sys->cfg->interrupt_ps - n->sys->cfg->interrupt_ps / 2);

    n->in_handler = false;
    handlers_open(n);
    n->info = before;
}

/* What the interrupted call is about, for reports: handlers make calls of their own. */
static void run_within(struct node *n)
{
    const char *call = n->call;
    long type = n->call_type, awaited = n->awaited;
    bool has_type = n->call_has_type, awaits = n->awaits, hands_over = n->hands_over;
    vtime since = n->call_since;
    run_first(n);
    n->call = call, n->call_type = type, n->call_has_type = has_type, n->call_since = since;
    n->awaited = awaited, n->awaits = awaits, n->hands_over = hands_over;
}

bool handlers_mask(struct node *n, bool masked)
{
    bool before = n->masked;
    n->masked = masked;
    return before;
}

void handlers_need_no_share(struct node *n)
{
    n->share_until = 0;
}

void handlers_share_used(struct node *n, vtime t)
{
    uint64_t left = n->share_until > n->lp.clock.units ? n->share_until - n->lp.clock.units : 0, used;
    if (!left || n->in_handler)
        return;
    used = clock_units_in(&n->lp, t);
    n->share_until -= used < left ? used : left;
}

/* Runs it; the program, which would have gone on meanwhile, has its share before the next. */
static void interrupt(struct node *n)
{
    const uint64_t share = n->sys->cfg->program_milli;
    vtime begun = node_now(n);
    run_within(n);
    vtime stood = node_now(n) - begun;
    n->stats.stood += stood;
    n->share_until = (n->share_until > n->lp.clock.units ? n->share_until : n->lp.clock.units) +
                     clock_units_in(&n->lp, stood / (1000 - share) * share);
}

bool handlers_run(struct node *n, bool waits)
{
    if (!first_due(&n->mailbox) || !handlers_due(n, node_now(n)))
        return false;
    if (waits)
        run_within(n);
    else if (n->share_until <= n->lp.clock.units)
        interrupt(n);
    else
        return false;
    return true;
}

bool handlers_run_held(struct node *n, vtime t)
{
    if (!handlers_due(n, t))
        return false;
    interrupt(n);
    return true;
}
