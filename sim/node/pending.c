/* pending.c - see pending.h. */
#include "node/pending.h"
#include <assert.h>
#include <stdlib.h>
#include "node/clock.h"
#include "node/cpu.h"
#include "node/mailbox.h"
#include "node/system.h"

/* A node's messages that wait for their turn should still be in the caches then. */
enum { MOST = 16 };

struct pending_call {
    uint64_t units; /* the node's clock at its beginning */
    vtime origin;
    struct node_memory memory; /* then */
    const char *name;          /* as node.call, and so on */
    long type;
    bool has_type;
    vtime since;
    vtime spent, copied;
    struct receive *receive;
    struct message *messages; /* sent, linked by next; afterwards, if they are short, they may be gone */
    uint64_t receivers;
    struct message *taken; /* linked by next */

    /* made: for taking it back */
    struct message *selected; /* by receive, NULL: it is posted */
    vtime sending;
    struct node_memory before;
};

static struct pending_call *nth(const struct node *n, uint32_t i)
{
    return &n->pending.calls[(n->pending.first + i) % MOST];
}

static struct pending_call *open_call(const struct node *n)
{
    assert(n->pending.open);
    return nth(n, n->pending.made + n->pending.count - 1);
}

bool pending_room(const struct node *n)
{
    return n->pending.made + n->pending.count < MOST;
}

/* Field by field: what is not set here is set before it is looked at. */
static void note(struct pending_call *c, const struct node *n)
{
    c->units = n->clock.units, c->origin = n->clock.origin;
    c->memory = node_memory_now(n);
    c->name = n->call, c->type = n->call_type, c->has_type = n->call_has_type, c->since = n->call_since;
    c->spent = c->copied = 0;
    c->receive = NULL, c->messages = NULL, c->taken = NULL;
}

void pending_begin(struct node *n, bool made)
{
    struct node_pending *p = &n->pending;
    assert(!made || p->count == 0);
    if (!p->calls && !(p->calls = malloc(MOST * sizeof *p->calls)))
        abort();
    if (p->made + p->count == 0)
        p->first = 0; /* the same few lines of memory again */
    p->quiet = p->count == 0 || p->quiet;
    p->made += made;
    p->count += !made;
    p->open = true;
    note(open_call(n), n);
}

void pending_spend(struct node *n, enum node_task task, vtime t)
{
    assert(task == NODE_CALL || task == NODE_COPYING);
    *(task == NODE_CALL ? &open_call(n)->spent : &open_call(n)->copied) += t;
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

void pending_take(struct node *n, struct message *m)
{
    struct pending_call *c = open_call(n);
    m->next = c->taken;
    c->taken = m;
}

static vtime time_of(const struct node *n, const struct pending_call *c)
{
    return c->origin + clock_of_units(n, c->units);
}

vtime pending_next(const struct node *n)
{
    return time_of(n, nth(n, n->pending.made));
}

/* All that the program has done after c comes so much later. */
static void put_back(struct node *n, const struct pending_call *c, vtime late)
{
    vtime begun = time_of(n, c);
    for (uint32_t i = 0; i < n->pending.count; i++)
        nth(n, i)->origin += late, nth(n, i)->since += late;
    n->clock.origin += late;
    if (n->call_since > begun)
        n->call_since += late;
    if (n->failed_malloc_at > begun)
        n->failed_malloc_at += late;
}

/* --- making them --- */

static void make(struct node *n, struct pending_call *c, vtime now)
{
    n->clock.known = c->units;
    node_memory_was(n, c->memory);
    node_account(n, NODE_CALL, c->spent);
    now += c->spent;
    if (c->receive)
        mailbox_post_at(n, c->receive, now);
    if (c->messages)
        mailbox_send(n, c->messages, c->receivers, now);
}

/* The same before its turn, in a way that can be taken back. */
static void make_early(struct node *n, struct pending_call *c)
{
    c->before = (struct node_memory){n->heap_known, n->stats.memory_peak};
    c->sending = 0;
    for (const struct message *m = c->messages; m; m = m->next)
        c->sending += mailbox_send_time(n, m);
    make(n, c, time_of(n, c));
    c->selected = c->receive ? c->receive->m : NULL;
    node_account(n, NODE_COPYING, c->copied);
    for (const struct message *m = c->taken; m; m = m->next)
        n->buffered -= m->buffered ? m->bytes : 0;
    if (c->taken)
        n->buffered_known = n->buffered;
}

bool pending_end(struct node *n)
{
    struct pending_call *c = open_call(n);
    n->pending.open = false;
    if (n->pending.count == 0) {
        make_early(n, c);
        return true;
    }
    return !n->pending.quiet || (!c->messages && !(c->receive && mailbox_has(n, c->receive)));
}

void pending_make(struct node *n)
{
    for (struct node_pending *p = &n->pending; p->count; p->count--)
        make_early(n, nth(n, p->made++));
}

vtime pending_tell(struct node *n)
{
    n->pending.quiet = false;
    return pending_next(n);
}

vtime pending_crashes(struct node *n)
{
    vtime t = time_of(n, open_call(n));
    pending_end(n);
    return t;
}

static void free_all(struct message *m)
{
    for (struct message *next; m; m = next) {
        next = m->next;
        proto_message_free(m);
    }
}

/* Their turn has come, and gone. */
void pending_forget(struct node *n)
{
    for (; n->pending.made; n->pending.made--) {
        free_all(nth(n, 0)->taken);
        n->pending.first = (n->pending.first + 1) % MOST;
    }
}

void pending_commit(struct node *n, vtime now)
{
    pending_forget(n);
    struct pending_call c = *nth(n, 0);
    n->pending.first = (n->pending.first + 1) % MOST;
    n->pending.count--;
    if (now > time_of(n, &c))
        put_back(n, &c, now - time_of(n, &c));
    make(n, &c, now);
}

bool pending_make_until(struct node *n, struct instant at)
{
    while (n->pending.count && instant_before(pending_next(n), n->place, at))
        pending_commit(n, pending_next(n));
    return n->pending.count > 0;
}

/* --- taking them back --- */

static void drop(struct message *m)
{
    for (struct message *next; m; m = next) {
        next = m->next;
        if (m->send)
            mailbox_unfollow(m->send);
        proto_message_free(m);
    }
}

/* In reverse: as if it had not been made. */
static void unmake(struct node *n, struct pending_call *c)
{
    for (struct message *m = c->taken, *next; m; m = next) {
        next = m->next;
        n->buffered += m->buffered ? m->bytes : 0;
        mailbox_put_back(n, m);
    }
    for (struct message *m = c->messages; m; m = m->next) {
        if (m->send)
            mailbox_unfollow(m->send);
        proto_take_back(m);
    }
    if (c->messages)
        n->stats.sent -= c->receivers, n->stats.sent_bytes -= c->receivers * c->messages->bytes;
    if (c->receive && !(c->selected && !c->selected->receive)) /* else the message was taken, see above */
        mailbox_withdraw(n, c->receive);
    node_account(n, NODE_SENDING, -c->sending);
    node_account(n, NODE_COPYING, -c->copied);
    node_account(n, NODE_CALL, -c->spent);
    n->heap_known = c->before.heap, n->stats.memory_peak = c->before.peak;
}

/* How many of those that have been made have happened before? */
static uint32_t happened(const struct node *n, struct instant at)
{
    uint32_t i = 0;
    while (i < n->pending.made && instant_before(time_of(n, nth(n, i)), n->place, at))
        i++;
    return i;
}

void pending_take_back(struct node *n, struct instant at)
{
    struct node_pending *p = &n->pending;
    assert(!p->open);
    uint32_t first = happened(n, at);
    if (first == p->made + p->count)
        return;
    const struct pending_call *c = nth(n, first);
    n->clock.units = c->units, n->clock.origin = c->origin;
    n->call = c->name, n->call_type = c->type, n->call_has_type = c->has_type; /* as it was when it began */
    n->call_since = c->since;
    for (; p->count; p->count--)
        drop(nth(n, p->made + p->count - 1)->messages);
    for (; p->made > first; p->made--)
        unmake(n, nth(n, p->made - 1));
}

void pending_free(struct node *n)
{
    pending_forget(n);
    for (; n->pending.count; n->pending.count--)
        drop(nth(n, n->pending.count - 1)->messages);
    free(n->pending.calls);
    n->pending.calls = NULL;
}
