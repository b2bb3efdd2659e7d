/* pending.c - see pending.h. */
#include "node/pending.h"
#include <assert.h>
#include <stddef.h>
#include <stdlib.h>
#include "node/clock.h"
#include "node/cpu.h"
#include "node/mailbox.h"
#include "node/system.h"
#include "node/turns.h"

/* A node's messages that wait for their turn should still be in the caches then. */
enum { MOST = 16, LINE = 64 };

/* What is looked at in its turn is in the first line of the cache. */
struct pending_call {
    vtime turn;     /* less node_pending.late at its beginning */
    uint64_t units; /* the node's clock then */
    struct node_memory memory;
    vtime spent;
    struct receive *receive;
    struct message *message; /* to be sent in its turn */
    bool selected;           /* receive has had its message from those that waited, before its turn */
    bool in_turn;            /* is to be made in its turn */
    bool sends;              /* message has been sent before */
    bool takes;              /* what it has waited for */
    bool has_type;           /* name and so on: as in struct node */

    const char *name;
    long type;
    vtime since, sending, copied;
    uint64_t bytes;        /* of message, which may be gone when it has been sent */
    struct message *taken; /* linked by next */
};
_Static_assert(offsetof(struct pending_call, name) == LINE && sizeof(struct pending_call) <= 2 * LINE,
               "a pending call takes two lines of the cache");

static struct pending_call *nth(const struct node *n, uint32_t i)
{
    return &n->pending.calls[(n->pending.first + i) % MOST];
}

static struct pending_call *last(const struct node *n)
{
    assert(n->pending.count);
    return nth(n, n->pending.count - 1);
}

static struct pending_call *open_call(const struct node *n)
{
    assert(n->pending.open);
    return last(n);
}

static vtime time_of(const struct node *n, const struct pending_call *c)
{
    return c->turn + n->pending.late + n->clock.stolen;
}

bool pending_room(const struct node *n)
{
    return n->pending.count < MOST;
}

static struct pending_call *new_calls(void)
{
    struct pending_call *calls = aligned_alloc(LINE, MOST * sizeof *calls);
    if (!calls)
        abort();
    return calls;
}

void pending_begin(struct node *n)
{
    struct node_pending *p = &n->pending;
    if (!p->calls)
        p->calls = new_calls();
    if (p->count == 0)
        p->first = 0, p->late = 0; /* the same few lines of memory again */
    p->count++;
    p->open = true;
    *open_call(n) = (struct pending_call){.turn = clock_sync(n) - p->late,
                                          .units = n->clock.units,
                                          .memory = node_memory_now(n),
                                          .name = n->call,
                                          .type = n->call_type,
                                          .has_type = n->call_has_type,
                                          .since = n->call_since - p->late};
}

/* Nothing comes to the node before the turn of what has waited: its program knows what is in its buffers then. */
static void know_buffers(struct node *n)
{
    n->buffered_known = n->buffered - n->pending.taken;
}

void pending_go_on(struct node *n)
{
    pending_begin(n);
    know_buffers(n);
}

void pending_spend(struct node *n, enum node_task task, vtime t)
{
    assert(task == NODE_CALL || task == NODE_COPYING);
    struct pending_call *c = open_call(n);
    if (task == NODE_CALL)
        c->spent += t;
    else
        c->copied += t;
    n->clock.origin += t;
}

/* A long message that waits for room is granted it in the call's turn. */
void pending_post(struct node *n, struct receive *r)
{
    struct pending_call *c = open_call(n);
    assert(!c->receive);
    c->receive = r;
    if (n->pending.selects)
        return; /* one before may select another message first */
    const struct message *m = mailbox_first(n, r);
    if (m && m->is_long && !m->granted) {
        pending_may_select(n);
    } else if (m) {
        mailbox_post_at(n, r, 0);
        c->selected = true;
    }
}

void pending_may_select(struct node *n)
{
    for (uint32_t i = 0; i < n->pending.count; i++) {
        struct pending_call *c = nth(n, i);
        bool may = c->receive && !c->selected;
        c->in_turn |= may;
        n->pending.selects |= may;
    }
    turn_tell(n);
}

void pending_send(struct node *n, struct message *m)
{
    struct pending_call *c = open_call(n);
    assert(!c->message && !m->next);
    c->message = m;
    c->sending = mailbox_send_time(n, m), c->bytes = m->bytes;
    n->clock.origin += c->sending;
    c->sends = !n->pending.told && node_is_alone(n, time_of(n, c)); /* what is told comes before */
    c->in_turn = !c->sends;
    if (c->sends)
        proto_send(m->proto, m, clock_sync(n));
    else
        turn_tell(n);
}

static size_t buffered(const struct message *m)
{
    return m->buffered ? m->bytes : 0;
}

void pending_take(struct node *n, struct message *m)
{
    struct pending_call *c = open_call(n);
    m->next = c->taken;
    c->taken = m;
    c->takes = true;
    n->pending.taken += buffered(m);
    know_buffers(n);
}

vtime pending_turn(const struct node *n)
{
    for (uint32_t i = 0; i < n->pending.count; i++)
        if (nth(n, i)->in_turn)
            return time_of(n, nth(n, i));
    return VT_NEVER;
}

vtime pending_last(const struct node *n)
{
    return time_of(n, last(n));
}

/* --- making them --- */

/* What has been stolen puts off the first, which begins now, and with it all that the program has done after it. */
static void put_off(struct node *n, vtime now)
{
    vtime late = n->clock.stolen, begun = now - late;
    n->clock.stolen = 0;
    n->clock.origin += late;
    n->pending.late += late;
    if (n->call_since > begun)
        n->call_since += late;
    if (n->failed_malloc_at > begun)
        n->failed_malloc_at += late;
}

static void take(struct node *n, const struct pending_call *c, vtime now)
{
    node_account(n, NODE_COPYING, c->copied);
    for (struct message *m = c->taken, *next; m; m = next) {
        next = m->next;
        n->pending.taken -= buffered(m);
        mailbox_done_with(n, m, now + c->copied);
    }
}

static void make(struct node *n, const struct pending_call *c, vtime now)
{
    n->clock.known = c->units;
    node_memory_was(n, c->memory);
    node_account(n, NODE_CALL, c->spent);
    now += c->spent;
    if (c->receive && !c->selected)
        mailbox_post_at(n, c->receive, now);
    if (c->sends)
        mailbox_has_sent(n, 1, c->bytes, c->sending);
    else if (c->message)
        mailbox_send(n, c->message, 1, now);
    if (c->takes)
        take(n, c, now);
}

void pending_make_until(struct node *n, struct instant at)
{
    struct node_pending *p = &n->pending;
    while (p->count) {
        const struct pending_call *c = nth(n, 0);
        vtime now = time_of(n, c);
        if (!instant_before(now, n->place, at))
            return;
        if (n->clock.stolen)
            put_off(n, now);
        make(n, c, now);
        p->first = (p->first + 1) % MOST;
        p->count--;
        p->selects = p->selects && p->count;
    }
}

/* --- taking them back --- */

static void unmake(struct node *n, struct pending_call *c)
{
    for (struct message *m = c->taken, *next; m; m = next) {
        next = m->next;
        n->pending.taken -= buffered(m);
        mailbox_put_back(n, m);
    }
    if (c->message && c->message->send)
        mailbox_unfollow(c->message->send);
    if (c->sends)
        proto_take_back(c->message);
    else if (c->message)
        proto_message_free(c->message);
    if (c->selected && c->receive->m)
        mailbox_withdraw(n, c->receive);
}

void pending_take_back(struct node *n)
{
    struct node_pending *p = &n->pending;
    assert(!p->open);
    if (p->count == 0)
        return;
    const struct pending_call *c = nth(n, 0);
    n->clock.units = c->units, n->clock.origin = c->turn + p->late - clock_of_units(n, c->units);
    n->call = c->name, n->call_type = c->type, n->call_has_type = c->has_type; /* as it was when it began */
    n->call_since = c->since + p->late;
    for (; p->count; p->count--)
        unmake(n, last(n));
    p->selects = false;
}

void pending_free(struct node *n)
{
    for (struct node_pending *p = &n->pending; p->count; p->count--)
        unmake(n, last(n));
    free(n->pending.calls);
    n->pending.calls = NULL;
}
