/* deferred.c - see deferred.h. */
#include "os/deferred.h"
#include <assert.h>
#include <stddef.h>
#include "kernel/xalloc.h"
#include "lp/clock.h"
#include "lp/deferral.h"
#include "lp/lookahead.h"
#include "node/system.h"
#include "os/charge.h"
#include "os/match.h"
#include "os/memory.h"
#include "os/observer.h"
#include "os/unexpected.h"
#include "os/gate.h"

#define TIME_MASK ((UINT64_C(1) << DEFERRED_TIME_BITS) - 1)

static uint32_t index_of(const struct node *n, uint32_t i)
{
    return (n->deferred.first + i) % DEFERRED_MOST;
}

static struct deferred_call *first(struct node *n)
{
    return &n->calls[n->deferred.first];
}

/* The set of the last alone. */
static uint16_t only_last(const struct node *n)
{
    return (uint16_t)(1u << index_of(n, n->deferred.count - 1));
}

static struct deferred_call *nth(const struct node *n, uint32_t i)
{
    return (struct deferred_call *)&n->calls[index_of(n, i)];
}

static struct deferred_call *last(const struct node *n)
{
    assert(n->deferred.count);
    return nth(n, n->deferred.count - 1);
}

static struct deferred_call *open_call(const struct node *n)
{
    assert(n->deferred.open);
    return last(n);
}

static vtime time_of(const struct node *n, vtime noted)
{
    return noted + n->deferred.shift + n->lp.clock.stolen;
}

bool deferred_has_room(const struct node *n)
{
    return n->deferred.count < DEFERRED_MOST &&
           (n->call.since | n->lp.clock.units) >> (DEFERRED_TIME_BITS - 1) == 0; /* the call may last */
}

static __attribute__((noinline, cold)) struct deferred_cold *new_cold(struct node *n)
{
    return n->cold->deferred = xcalloc(1, sizeof *n->cold->deferred);
}

static inline struct deferred_cold *cold_of(struct node *n)
{
    return n->cold->deferred ? n->cold->deferred : new_cold(n);
}

void deferred_begin(struct node *n)
{
    struct deferred *p = &n->deferred;
    if (p->count == 0)
        p->first = 0, p->shift = 0,
        p->commits = node_now(n); /* so that the ring uses the same few lines of the cache */
    uint32_t i = index_of(n, p->count++);
    p->open = true;
    n->calls[i] = (struct deferred_call){.commits = (node_now(n) - p->shift) & TIME_MASK,
                                         .units = n->lp.clock.units & TIME_MASK,
                                         .has_memory = n->memory.heap_moved,
                                         .name = n->call.name};
    if (n->memory.heap_moved)
        cold_of(n)->memory[i] = node_memory_now(n);
    n->memory.heap_moved = false;
    ANNOUNCE(n, deferred);
}

void deferred_ask(struct node *n)
{
    deferred_begin(n);
    last(n)->asks = true;
}

bool deferred_only_ask(const struct node *n)
{
    return last(n)->asks;
}

/* Nothing reaches the node before the call that has waited is committed: its program knows what is in its
 * buffers then. */
static void know_buffers(struct node *n)
{
    n->memory.buffered_known = n->memory.buffered - n->memory.taken;
}

static struct message *message_of(const struct node *n, uint32_t i)
{
    const struct deferred_call *c = nth(n, i);
    return c->cold ? n->cold->deferred->message[index_of(n, i)] : c->message;
}

/* When the i-th call, whose caller resumes, has handed over what it has to, as noted. */
static vtime handed_over(const struct node *n, uint32_t i)
{
    const struct deferred_call *c = nth(n, i);
    assert(!c->has_message || c->cold);
    return c->commits + c->spent + (c->has_message ? n->cold->deferred->sending[index_of(n, i)] : 0);
}

void deferred_resume_caller(struct node *n)
{
    struct deferred *p = &n->deferred;
    if (p->count == 0) { /* it is committed */
        deferred_begin(n);
        p->begun = n->call.since;
        ANNOUNCE(n, deferred_again);
    }
    p->open = true;
    struct deferred_call *c = open_call(n);
    c->resumes_caller = true;
    n->cold->deferred_type[index_of(n, p->count - 1)] = (int32_t)n->call.type, c->has_type = n->call.has_type;
    assert(handed_over(n, p->count - 1) == node_now(n) - p->shift);
    know_buffers(n);
}

static void account(struct node *n, enum node_task task, vtime t)
{
    clock_advance(&n->lp, t);
    node_account(n, task, t);
}

void deferred_spend(struct node *n, vtime t)
{
    struct deferred_call *c = open_call(n);
    assert(!c->resumes_caller);
    c->spent += t;
    account(n, NODE_CALL, t);
}

static __attribute__((noinline)) void put_cold(struct node *n, struct message *m)
{
    uint32_t i = index_of(n, n->deferred.count - 1);
    cold_of(n)->message[i] = m;
    cold_of(n)->sending[i] = match_send_time(n, m); /* m may be gone when the call is committed */
    last(n)->cold = true;
}

/* What the receive of the i-th call finds now, if it is to be posted: no message that comes later is before a
 * whole one. For one that is coming the call needs an event. */
static void find(struct node *n, uint32_t i)
{
    struct deferred *p = &n->deferred;
    struct deferred_call *c = nth(n, i);
    const uint16_t this = (uint16_t)(1u << index_of(n, i));
    struct message *m = p->posts & this ? unexpected_first(n, &c->receive->select) : NULL;
    if (m && m->whole)
        match_select(n, c->receive, m, 0), c->selected = true, p->posts &= (uint16_t) ~this;
    else if (m)
        p->needs_event |= this;
}

void deferred_post(struct node *n, struct receive *r)
{
    struct deferred *p = &n->deferred;
    struct deferred_call *c = open_call(n);
    assert(!(p->posts & only_last(n)) && !c->selected && !c->resumes_caller);
    if (c->has_message)
        put_cold(n, c->message);
    c->receive = r;
    p->posts |= only_last(n);
    find(n, p->count - 1u);
    if (p->posts & p->needs_event & only_last(n))
        lp_schedule_deferred(&n->lp);
}

void deferred_may_select(struct node *n)
{
    struct deferred *p = &n->deferred;
    for (uint32_t i = 0; i < p->count && p->posts; i++)
        find(n, i);
    if (p->posts & p->needs_event)
        lp_schedule_deferred(&n->lp);
}

void deferred_send(struct node *n, struct message *m)
{
    struct deferred *p = &n->deferred;
    struct deferred_call *c = open_call(n);
    assert(!c->has_message && !m->next && !c->resumes_caller);
    c->sends = !n->lp.scheduled_at &&
               lp_is_alone(&n->lp, time_of(n, c->commits)); /* an event of the node's own would come before */
    vtime sending = match_send_time(n, m);
    clock_advance(&n->lp, sending);
    if (c->sends) {
        node_account(n, NODE_SENDING, sending);
        protocol_send_late(n->sys->schedule.protocol, m, node_now(n), match_send_late(n));
    }
    c->has_message = true;
    if (p->posts & only_last(n) || c->selected)
        put_cold(n, m);
    else
        c->message = m;
    if (!c->sends) {
        p->needs_event |= only_last(n);
        lp_schedule_deferred(&n->lp);
    }
}

static size_t buffered(const struct message *m)
{
    return m->buffered ? m->bytes : 0;
}

void deferred_received(struct node *n, struct message *m)
{
    struct deferred_call *c = open_call(n);
    assert(c->resumes_caller && !(n->deferred.posts & only_last(n)) && (!c->has_message || c->cold));
    c->inline_message = !c->consumes_message && !m->buffered && protocol_message_is_plain(m);
    m->next = c->consumes_message ? c->consumed : NULL;
    c->consumed = m;
    c->selected = false, c->consumes_message = true;
    account(n, NODE_COPYING, node_system_time(n, match_copying(n, m)));
    n->memory.taken += buffered(m);
    know_buffers(n);
}

vtime deferred_next(const struct node *n, struct message **sends)
{
    const struct deferred *p = &n->deferred;
    if (!p->needs_event)
        return VT_NEVER;
    uint32_t from_first = p->needs_event >> p->first | (uint32_t)p->needs_event << (DEFERRED_MOST - p->first);
    uint32_t i = (uint32_t)__builtin_ctz(from_first);
    const struct deferred_call *c = nth(n, i);
    *sends = c->has_message ? message_of(n, i) : NULL;
    return time_of(n, c->commits);
}

vtime deferred_last(const struct node *n)
{
    const struct deferred_call *c = last(n);
    return time_of(n, c->resumes_caller ? handed_over(n, n->deferred.count - 1) : c->commits);
}

/* --- committing --- */

/* Stolen time puts off the first call, which begins now, and with it all that the program has done since. */
static void put_off(struct node *n, vtime now)
{
    vtime late = clock_add_stolen(&n->lp), begun = now - late;
    n->deferred.shift += late;
    n->deferred.commits += late;
    if (n->call.since >= begun && n->call.since != VT_NEVER)
        n->call.since += late;
}

/* How long the system copies messages that the call has received: m, and those received before it. */
static vtime copying(const struct node *n, const struct message *m)
{
    vtime t = 0;
    for (; m; m = m->next)
        t += node_system_time(n, match_copying(n, m));
    return t;
}

static void take(struct node *n, const struct deferred_call *c, vtime now)
{
    if (c->inline_message) {
        protocol_message_free_plain(n->sys->schedule.protocol, c->consumed);
        return;
    }
    now += copying(n, c->consumed);
    for (struct message *m = c->consumed, *next; m; m = next) {
        next = m->next;
        n->memory.taken -= buffered(m);
        match_done_with(n, m, now);
    }
}

/* The call's commit time: hands over what it has to. */
static void begin(struct node *n, struct deferred_call *c, vtime now)
{
    n->deferred.begun = now;
    if (c->has_memory)
        node_memory_was(n, n->cold->deferred->memory[index_of(n, 0)]);
    if (n->deferred.posts >> n->deferred.first & 1)
        match_post(n, c->receive, now + c->spent);
    if (c->has_message && !c->sends) {
        ANNOUNCE(n, charges_deferred, 0);
        match_send(n, message_of(n, 0), now + c->spent);
        ANNOUNCE(n, charges_program);
    }
}

/* The first has handed over what it had to. */
static void done_with(struct node *n)
{
    const uint16_t others = (uint16_t) ~(1u << n->deferred.first);
    n->deferred.posts &= others, n->deferred.needs_event &= others;
}

static void pop(struct node *n)
{
    struct deferred *p = &n->deferred;
    p->first = (uint8_t)index_of(n, 1);
    p->count--;
    p->begun = VT_NEVER;
    if (p->count)
        p->commits = first(n)->commits + p->shift;
}

static void make(struct node *n, struct deferred_call *c, vtime now)
{
    struct deferred *p = &n->deferred;
    if (p->begun == VT_NEVER) {
        vtime done = c->resumes_caller ? handed_over(n, 0) : 0;
        ANNOUNCE(n, committed, now);
        begin(n, c, now);
        done_with(n);
        if (c->resumes_caller) {
            p->commits = done + p->shift;
            c->commits = done & TIME_MASK, c->spent = 0;
            c->selected = c->has_message = c->sends = false;
            return;
        }
    } else {
        const struct message *taken = c->consumes_message ? c->consumed : NULL;
        ANNOUNCE(n, resumed, now, now + copying(n, taken ? taken->next : NULL), now + copying(n, taken));
        if (c->consumes_message)
            take(n, c, now);
    }
    clock_note_committed(&n->lp, c->units);
    ANNOUNCE(n, popped);
    pop(n);
}

void deferred_commit(struct node *n, struct instant before)
{
    do {
        vtime now = n->deferred.commits + n->lp.clock.stolen;
        if (n->lp.clock.stolen)
            put_off(n, now);
        make(n, first(n), now);
    } while (deferred_is_due(n, before));
}

/* --- rolling back --- */

static void put_back(struct node *n, const struct deferred_call *c)
{
    for (struct message *m = c->consumed, *next; m; m = next) {
        next = m->next;
        charge_undo(n, NODE_COPYING, node_system_time(n, match_copying(n, m)));
        n->memory.taken -= buffered(m);
        match_put_back(n, m);
    }
}

static void unsend(struct node *n, const struct deferred_call *c, struct message *m)
{
    n->stats.sent--, n->stats.sent_bytes -= m->bytes;
    if (m->followed)
        match_unfollow(m->send);
    if (!c->sends) {
        protocol_message_free(m);
        return;
    }
    charge_undo(n, NODE_SENDING, match_send_time(n, m));
    protocol_take_back(m);
}

/* Undoes the last call. */
static void unmake(struct node *n)
{
    struct deferred_call *c = last(n);
    ANNOUNCE(n, charges_deferred, n->deferred.count - 1);
    if (c->consumes_message)
        put_back(n, c);
    if (c->has_message)
        unsend(n, c, message_of(n, n->deferred.count - 1));
    if (c->selected && c->receive->m)
        match_withdraw(n, c->receive);
    charge_undo(n, NODE_CALL, c->spent);
    ANNOUNCE(n, charges_program);
}

void deferred_undo(struct node *n)
{
    struct deferred *p = &n->deferred;
    ANNOUNCE(n, rolled_back);
    for (; p->count; p->count--)
        unmake(n);
    p->posts = p->needs_event = 0;
    p->begun = VT_NEVER;
    assert(n->memory.taken == 0); /* what the calls had received is unexpected again */
}

void deferred_roll_back(struct node *n)
{
    struct deferred *p = &n->deferred;
    assert(!p->open);
    if (p->count == 0)
        return;
    const struct deferred_call *c = first(n);
    clock_return_to(&n->lp, c->units, p->commits);
    n->wait.at_poll = false;
    uint32_t i = index_of(n, 0);
    n->call.name = p->begun == VT_NEVER ? NULL : c->name; /* otherwise the program has not come to the call */
    n->call.since = p->begun;
    n->call.type = n->cold->deferred_type[i], n->call.has_type = c->has_type;
    deferred_undo(n);
}
