/* pending.c - see pending.h. */
#include "node/pending.h"
#include <assert.h>
#include <stddef.h>
#include "node/clock.h"
#include "node/account.h"
#include "node/mailbox.h"
#include "node/system.h"
#include "node/turns.h"
#include "node/unexpected.h"

#define TIME_MASK ((UINT64_C(1) << PENDING_TIME_BITS) - 1)

static uint32_t index_of(const struct node *n, uint32_t i)
{
    return (n->pending.first + i) % PENDING_MOST;
}

static struct pending_call *nth(const struct node *n, uint32_t i)
{
    return (struct pending_call *)&n->calls[index_of(n, i)];
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

static vtime time_of(const struct node *n, vtime turn)
{
    return turn + n->pending.late + n->clock.stolen;
}

bool pending_room(const struct node *n)
{
    return n->pending.count < PENDING_MOST && (n->call_since | n->clock.units) >> PENDING_TIME_BITS == 0;
}

void pending_begin(struct node *n)
{
    struct node_pending *p = &n->pending;
    if (p->count == 0)
        p->first = 0, p->late = 0, p->turn = clock_sync(n); /* the same few lines of memory again */
    uint32_t i = index_of(n, p->count++);
    p->open = true;
    n->calls[i] = (struct pending_call){.turn = (clock_sync(n) - p->late) & TIME_MASK,
                                        .units = n->clock.units & TIME_MASK,
                                        .has_memory = n->heap_moved,
                                        .name = n->call};
    if (n->heap_moved)
        n->beside->calls.memory[i] = node_memory_now(n);
    n->heap_moved = false;
}

/* Nothing comes to the node before the turn of what has waited: its program knows what is in its buffers then. */
static void know_buffers(struct node *n)
{
    n->buffered_known = n->buffered - n->taken;
}

static struct message *message_of(const struct node *n, uint32_t i)
{
    const struct pending_call *c = nth(n, i);
    return c->beside ? n->beside->calls.message[index_of(n, i)] : c->message;
}

/* When the i-th is done with what it hands over. */
static vtime handed_over(const struct node *n, uint32_t i)
{
    const struct pending_call *c = nth(n, i);
    return c->turn + c->spent + (c->has_message ? mailbox_send_time(n, message_of(n, i)) : 0);
}

void pending_go_on(struct node *n)
{
    struct node_pending *p = &n->pending;
    if (p->count == 0) { /* it has had its turn */
        pending_begin(n);
        p->begun = n->call_since;
    }
    p->open = true;
    struct pending_call *c = open_call(n);
    c->goes_on = true;
    n->beside->calls.type[index_of(n, p->count - 1)] = (int32_t)n->call_type, c->has_type = n->call_has_type;
    assert(handed_over(n, p->count - 1) == clock_sync(n) - p->late);
    know_buffers(n);
}

static void account(struct node *n, enum node_task task, vtime t)
{
    n->clock.now += t;
    node_account(n, task, t);
}

void pending_spend(struct node *n, vtime t)
{
    struct pending_call *c = open_call(n);
    assert(!c->goes_on);
    c->spent += t;
    account(n, NODE_CALL, t);
}

static void put_beside(struct node *n, struct message *m)
{
    n->beside->calls.message[index_of(n, n->pending.count - 1)] = m;
    last(n)->beside = true;
}

static void post(struct node *n, struct receive *r)
{
    struct pending_call *c = open_call(n);
    assert(!c->posts && !c->selected && !c->goes_on);
    if (c->has_message)
        put_beside(n, c->message);
    c->receive = r;
    c->posts = true;
    const struct message *m = unexpected_first(n, &r->select);
    if (n->pending.selects ||
        (m && !m->arrived)) { /* one before may select it, or another be the first then */
        pending_may_select(n);
    } else if (m) {
        mailbox_post_at(n, r, 0);
        c->posts = false, c->selected = true;
    }
}

void pending_may_select(struct node *n)
{
    for (uint32_t i = 0; i < n->pending.count; i++) {
        struct pending_call *c = nth(n, i);
        c->in_turn |= c->posts;
        n->pending.selects |= c->posts;
    }
    turn_tell(n);
}

static void send(struct node *n, struct message *m)
{
    struct pending_call *c = open_call(n);
    assert(!c->has_message && !m->next && !c->goes_on);
    c->sends = !n->pending.told && node_is_alone(n, time_of(n, c->turn)); /* what is told comes before */
    c->in_turn = !c->sends;
    vtime sending = mailbox_send_time(n, m);
    n->clock.now += sending;
    if (c->sends) {
        node_account(n, NODE_SENDING, sending);
        protocol_send(n->sys->protocol, m, clock_sync(n));
    }
    c->has_message = true;
    if (c->posts || c->selected)
        put_beside(n, m);
    else
        c->message = m;
    if (c->in_turn)
        turn_tell(n);
}

static size_t buffered(const struct message *m)
{
    return m->buffered ? m->bytes : 0;
}

static void receive(struct node *n, struct message *m)
{
    struct pending_call *c = open_call(n);
    assert(c->goes_on && !c->posts && (!c->has_message || c->beside));
    c->plain = !c->takes && !m->buffered && protocol_message_is_plain(m);
    m->next = c->takes ? c->taken : NULL;
    c->taken = m;
    c->selected = false, c->takes = true;
    account(n, NODE_COPYING, node_system_time(n, mailbox_copying(n, m)));
    n->taken += buffered(m);
    know_buffers(n);
}

/* --- calls made now, or pending --- */

void engine_post(struct node *n, struct receive *r)
{
    if (n->pending.open)
        post(n, r);
    else
        mailbox_post_at(n, r, node_now(n));
}

void engine_send(struct node *n, struct message *first)
{
    if (n->pending.open)
        send(n, first);
    else
        clock_advance_to(n, mailbox_send(n, first, node_now(n)));
}

void engine_received(struct node *n, struct message *m)
{
    if (n->pending.open) {
        receive(n, m);
    } else {
        node_spend_on(n, NODE_COPYING, mailbox_copying(n, m));
        mailbox_done_with(n, m, node_now(n));
    }
}

void engine_kept(struct node *n)
{
    if (n->pending.count)
        pending_may_select(n);
}

vtime pending_turn(const struct node *n, struct message **sends)
{
    for (uint32_t i = 0; i < n->pending.count; i++) {
        const struct pending_call *c = nth(n, i);
        if (!c->in_turn)
            continue;
        *sends = c->has_message ? message_of(n, i) : NULL;
        return time_of(n, c->turn);
    }
    return VT_NEVER;
}

vtime pending_last(const struct node *n)
{
    const struct pending_call *c = last(n);
    return time_of(n, c->goes_on ? handed_over(n, n->pending.count - 1) : c->turn);
}

/* --- making them --- */

/* What has been stolen puts off the first, which begins now, and with it all that the program has done after it. */
static void put_off(struct node *n, vtime now)
{
    vtime late = n->clock.stolen, begun = now - late;
    n->clock.stolen = 0;
    n->clock.now += late;
    n->pending.late += late;
    n->pending.turn += late;
    if (n->call_since >= begun && n->call_since != VT_NEVER)
        n->call_since += late;
}

static void take(struct node *n, const struct pending_call *c, vtime now)
{
    if (c->plain) {
        protocol_message_free_plain(n->sys->protocol, c->taken);
        return;
    }
    for (const struct message *m = c->taken; m; m = m->next)
        now += node_system_time(n, mailbox_copying(n, m));
    for (struct message *m = c->taken, *next; m; m = next) {
        next = m->next;
        n->taken -= buffered(m);
        mailbox_done_with(n, m, now);
    }
}

/* Its turn: what it hands over. */
static void begin(struct node *n, struct pending_call *c, vtime now)
{
    n->pending.begun = now;
    if (c->has_memory)
        node_memory_was(n, n->beside->calls.memory[index_of(n, 0)]);
    if (c->posts)
        mailbox_post_at(n, c->receive, now + c->spent);
    if (c->has_message && !c->sends)
        mailbox_send(n, message_of(n, 0), now + c->spent);
}

static void pop(struct node *n)
{
    struct node_pending *p = &n->pending;
    p->first = (uint16_t)index_of(n, 1);
    p->count--;
    p->begun = VT_NEVER;
    if (p->count)
        p->turn = nth(n, 0)->turn + p->late;
    else
        p->selects = false;
}

static void make(struct node *n, struct pending_call *c, vtime now)
{
    struct node_pending *p = &n->pending;
    if (p->begun == VT_NEVER) {
        vtime done = c->goes_on ? handed_over(n, 0) : 0;
        begin(n, c, now);
        if (c->goes_on) {
            p->turn = done + p->late;
            c->turn = done & TIME_MASK, c->spent = 0;
            c->posts = c->selected = c->in_turn = c->has_message = c->sends = false;
            return;
        }
    } else if (c->takes) {
        take(n, c, now);
    }
    clock_given_in_turn(n, c->units);
    pop(n);
}

void pending_make(struct node *n, struct instant at)
{
    while (n->pending.count) {
        vtime now = n->pending.turn + n->clock.stolen;
        if (!instant_before(now, n->place, at))
            return;
        if (n->clock.stolen)
            put_off(n, now);
        make(n, nth(n, 0), now);
    }
}

/* --- taking them back --- */

static void unaccount(struct node *n, enum node_task task, vtime t)
{
    n->stats.tasks[task] -= t;
    n->stats.system -= t;
}

static void put_back(struct node *n, const struct pending_call *c)
{
    for (struct message *m = c->taken, *next; m; m = next) {
        next = m->next;
        unaccount(n, NODE_COPYING, node_system_time(n, mailbox_copying(n, m)));
        n->taken -= buffered(m);
        mailbox_put_back(n, m);
    }
}

static void unsend(struct node *n, const struct pending_call *c, struct message *m)
{
    n->stats.sent--, n->stats.sent_bytes -= m->bytes;
    if (m->followed)
        mailbox_unfollow(m->send);
    if (!c->sends) {
        protocol_message_free(m);
        return;
    }
    unaccount(n, NODE_SENDING, mailbox_send_time(n, m));
    protocol_take_back(m);
}

/* The last. */
static void unmake(struct node *n)
{
    struct pending_call *c = last(n);
    if (c->takes)
        put_back(n, c);
    if (c->has_message)
        unsend(n, c, message_of(n, n->pending.count - 1));
    if (c->selected && c->receive->m)
        mailbox_withdraw(n, c->receive);
    unaccount(n, NODE_CALL, c->spent);
}

void pending_unmake(struct node *n)
{
    struct node_pending *p = &n->pending;
    for (; p->count; p->count--)
        unmake(n);
    p->selects = false;
    p->begun = VT_NEVER;
}

void pending_take_back(struct node *n)
{
    struct node_pending *p = &n->pending;
    assert(!p->open);
    if (p->count == 0)
        return;
    const struct pending_call *c = nth(n, 0);
    n->clock.units = c->units, n->clock.now = p->turn;
    n->at_poll = false;
    uint32_t i = index_of(n, 0);
    n->call = p->begun == VT_NEVER ? NULL : c->name; /* else it has not come so far */
    n->call_since = p->begun;
    n->call_type = n->beside->calls.type[i], n->call_has_type = c->has_type;
    pending_unmake(n);
}
