/* sim_messages.c - messages, time and reports of calls in the simulator: nx_api/contract/backend.h. */
#include "kernel/xalloc.h"
#include "machine/cube.h"
#include "nx_api/calls/call.h"
#include "net/protocol_record.h"
#include "os/charge.h"
#include "os/observer.h"
#include "os/asan_hooks.h"
#include "os/order_policy.h"

static bool handlers_have_run(struct node *n, void *arg)
{
    (void)arg;
    return n->sys->orders->lets_call_begin(n);
}

/* In a run that keeps orders no call is deferred: this one is committed. Handlers whose order is behind it
 * must not run before it does anything: so it is told of last. */
void nx_begins_call(struct node *n)
{
    if (order_policy_of(n) && !handlers_have_run(n, NULL))
        node_wait(n, handlers_have_run, NULL);
    ANNOUNCE(n, call_acts);
}

void nx_about(struct node *n, long what)
{
    gate_about(n, what);
    gate_awaits(n, what);
}

void nx_awaits(struct node *n, const struct receive *r, const struct send *s)
{
    ANNOUNCE(n, awaits, !r, r ? r->select.node : -1);
    gate_awaits(n, r ? (long)r->select.type : s->m ? (long)s->m->type : 0);
}

void nx_found_nothing(struct node *n, const struct selector *select)
{
    ANNOUNCE(n, finds_nothing, select);
}

void nx_spend_call(struct node *n)
{
    node_spend(n, n->sys->cfg->call_ps);
}

void nx_spend_kernel(struct node *n)
{
    if (n->sys->cfg->kernel_ps)
        node_spend(n, n->sys->cfg->kernel_ps);
}

struct own_calls *nx_own_calls(struct node *n)
{
    return &n->cold->own;
}

struct node_error *nx_last_error(struct node *n)
{
    struct node_cold *c = n->cold;
    if (!c->error)
        c->error = xcalloc(1, sizeof *c->error);
    return c->error;
}

uint32_t nx_message_ids(const struct node *n)
{
    return (uint32_t)n->sys->cfg->message_ids;
}

/* The host program must not send the library's own messages. */
long nx_check_way(struct node *n, long node)
{
    if (n->is_host && mailbox_is_library(n->call.type))
        return node_error(n, EQNODE,
                          "the global operations are the nodes': the host program takes no part in them");
    return n->is_host ? cube_check_send(n, node) : 0;
}

static uint32_t address_of(const struct node *n, long node)
{
    return node == n->sys->count ? n->sys->host->lp.address : (uint32_t)node;
}

static struct message *last(struct message *m)
{
    while (m->next)
        m = m->next;
    return m;
}

static void hand_over(struct node *n, struct message *m, uint64_t receivers)
{
    charge_sent(n, receivers, receivers * m->bytes);
    front_send(n, m);
}

/* An eager message has been copied into the system's memory when the call ends, so that no send need be
 * followed. In a program with handlers the call is made in order all the same: a due handler runs before the
 * call ends. */
bool nx_goes_at_once(const struct node *n, const struct outgoing *o)
{
    return !o->held && protocol_is_eager(n->sys->schedule.protocol, (word)o->type, (size_t)o->len) &&
           !n->handlers.armed;
}

inline void nx_send(struct node *n, const struct outgoing *o, struct send *s)
{
    struct protocol *p = n->sys->schedule.protocol;
    bool all = o->node == ALL_NODES;
    size_t len = (size_t)o->len;
    ASAN_CALL(n, false, o->buf, len);
    word type = (word)o->type, pid = (word)(o->in_order ? o->pid : n->pid); /* as programs give them */
    uint64_t order = IS_HEARD(n, sends) ? protocol_next_order(p, n->lp.address) : 0;
    struct message *m =
        all ? protocol_to_all(p, n->lp.address, type, pid, o->buf, len)
            : protocol_message(p, n->lp.address, address_of(n, o->node), type, pid, o->buf, len);
    if (o->in_order)
        m->in_order = true;
    if (o->held)
        protocol_hold(m);
    uint64_t receivers = !all ? 1 : n->is_host ? n->sys->count : n->sys->count - 1;
    ANNOUNCE(
        n, sends,
        &(struct observed_send){o->buf, len, m, s, order, protocol_next_order(p, n->lp.address) - order});
    if (s && (!m || nx_goes_at_once(n, o))) {
        s->done = true;
        s = NULL;
    }
    if (s)
        match_follow(last(m), s);
    if (m)
        hand_over(n, m, receivers);
}

void nx_flush(struct node *n, long node, int64_t typesel)
{
    for (uint32_t i = 0; i < n->sys->count; i++)
        if (node == ALL_NODES || node == (long)i)
            match_flush(n->sys->nodes[i], typesel, node_now(n));
    if (node == (long)n->sys->count)
        match_flush(n->sys->host, typesel, node_now(n));
}
