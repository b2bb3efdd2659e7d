/* pending.c - see pending.h. */
#include "node/pending.h"
#include <assert.h>
#include <stdlib.h>
#include "node/clock.h"
#include "node/cpu.h"
#include "node/mailbox.h"
#include "node/system.h"

/* A node's messages that wait for their turn should still be in the caches then. */
enum { MOST = 8 };

struct pending_call {
    uint64_t units; /* the node's clock at its beginning */
    vtime origin;
    struct node_memory memory; /* then */
    const char *name;          /* as node.call */
    vtime spent;
    struct receive *receive;
    struct message *messages;
    uint64_t receivers;
};

static struct pending_call *nth(const struct node *n, uint32_t i)
{
    return &n->pending.calls[(n->pending.first + i) % MOST];
}

static struct pending_call *open_call(const struct node *n)
{
    assert(n->pending.open);
    return nth(n, n->pending.count - 1);
}

bool pending_room(const struct node *n)
{
    return n->pending.count < MOST;
}

void pending_begin(struct node *n)
{
    struct node_pending *p = &n->pending;
    if (!p->calls && !(p->calls = malloc(MOST * sizeof *p->calls)))
        abort();
    if (p->count == 0)
        p->first = 0; /* the same few lines of memory again */
    p->count++;
    p->open = true;
    *open_call(n) = (struct pending_call){
        .units = n->clock.units, .origin = n->clock.origin, .memory = node_memory_now(n), .name = n->call};
}

void pending_spend(struct node *n, vtime t)
{
    open_call(n)->spent += t;
    n->clock.origin += t;
}

void pending_post(struct node *n, struct receive *r)
{
    assert(!open_call(n)->receive);
    open_call(n)->receive = r;
}

void pending_send(struct node *n, struct message *first, uint64_t receivers)
{
    struct pending_call *c = open_call(n);
    assert(!c->messages);
    c->messages = first, c->receivers = receivers;
    for (const struct message *m = first; m; m = m->next)
        n->clock.origin += mailbox_send_time(n, m);
}

void pending_end(struct node *n)
{
    n->pending.open = false;
}

static vtime time_of(const struct node *n, const struct pending_call *c)
{
    return c->origin + clock_of_units(n, c->units);
}

vtime pending_next(const struct node *n)
{
    return time_of(n, nth(n, 0));
}

/* All that the program has done after c comes so much later. */
static void put_back(struct node *n, const struct pending_call *c, vtime late)
{
    vtime begun = time_of(n, c);
    for (uint32_t i = 0; i < n->pending.count; i++)
        nth(n, i)->origin += late;
    n->clock.origin += late;
    if (n->call_since > begun)
        n->call_since += late;
    if (n->failed_malloc_at > begun)
        n->failed_malloc_at += late;
}

static struct pending_call take_first(struct node *n)
{
    struct pending_call c = *nth(n, 0);
    n->pending.first = (n->pending.first + 1) % MOST;
    n->pending.count--;
    return c;
}

void pending_commit(struct node *n, vtime now)
{
    struct pending_call c = take_first(n);
    if (now > time_of(n, &c))
        put_back(n, &c, now - time_of(n, &c));
    n->clock.known = c.units;
    node_memory_was(n, c.memory);
    node_account(n, NODE_CALL, c.spent);
    now += c.spent;
    if (c.receive)
        mailbox_post_at(n, c.receive, now);
    if (c.messages)
        mailbox_send(n, c.messages, c.receivers, now);
}

static void drop(struct message *m)
{
    for (struct message *next; m; m = next) {
        next = m->next;
        if (m->send)
            mailbox_unfollow(m->send);
        proto_message_free(m);
    }
}

void pending_take_back(struct node *n)
{
    if (n->pending.count == 0)
        return;
    pending_end(n);
    const struct pending_call *first = nth(n, 0);
    n->clock.units = first->units, n->clock.origin = first->origin;
    n->call = first->name, n->call_has_type = false; /* as it was when it began */
    n->call_since = time_of(n, first);
    while (n->pending.count)
        drop(take_first(n).messages);
}

void pending_free(struct node *n)
{
    while (n->pending.count)
        drop(take_first(n).messages);
    free(n->pending.calls);
    n->pending.calls = NULL;
}
