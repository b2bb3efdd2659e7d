/* match.c - see match.h. */
#include "os/match.h"
#include <stdlib.h>
#include "lp/engine.h"
#include "node/system.h"
#include "os/charge.h"
#include "os/due.h"
#include "os/flood.h"
#include "os/memory.h"
#include "os/observer.h"
#include "os/order_policy.h"
#include "os/unexpected.h"
#include "nx_api/contract/matching.h"

void match_begin(struct node *n)
{
    struct mailbox *b = &n->mailbox;
    *b = (struct mailbox){0};
    posted_begin(&b->posted);
    unexpected_begin(n);
}

/* Frees the receives that handlers were posted with. (The others belong to calls or to ids.) */
static void free_posted(struct mailbox *b)
{
    for (struct receive *r = b->posted.first, *next; r; r = next) {
        next = r->next;
        if (r->handler)
            free(r);
    }
}

static void free_messages(struct message *list)
{
    for (struct message *m = list, *next; m; m = next) {
        next = m->next;
        protocol_message_free(m);
    }
}

void match_end(struct node *n)
{
    struct mailbox *b = &n->mailbox;
    free_messages(b->whole);
    free_messages(n->unexpected.coming);
    unexpected_end(n);
    due_free(b);
    free_posted(b);
    ids_end(&b->ids); /* receives posted are in there */
}

/* --- system buffers --- */

static void buffer(struct node *n, struct message *m)
{
    m->buffered = true;
    n->memory.buffered += m->bytes;
    node_memory_changed(n);
    flood_check(n, m);
}

static bool room_for(struct node *n, const struct message *m)
{
    return node_memory_used(n) + m->bytes <= node_memory_limit(n);
}

/* Room has become free: clears the messages that wait for room to send, in the order of their requests. */
static inline void grant_waiting(struct node *n, vtime now)
{
    for (struct message *m = n->unexpected.coming; m && n->mailbox.waiting; m = m->next) {
        if (!m->is_long || m->cleared || m->held)
            continue;
        if (!room_for(n, m))
            return;
        n->mailbox.waiting--;
        buffer(n, m);
        protocol_clear_to_send(m->protocol, m, now);
    }
}

static void unbuffer(struct node *n, struct message *m, vtime now)
{
    if (!m->buffered)
        return;
    m->buffered = false;
    n->memory.buffered -= m->bytes;
    grant_waiting(n, now);
}

/* --- what the protocol tells --- */

static void give(struct node *n, struct receive *r, struct message *m)
{
    ANNOUNCE(n, gives, r, m);
    r->m = m;
    r->complete = m->arrived ? m->complete : VT_NEVER;
    m->receive = r;
}

bool match_envelope(void *ctx, struct message *m, vtime now)
{
    struct node *n = node_at(ctx, m->to);
    struct mailbox *b = &n->mailbox;
    if (m->unwanted)
        return true;
    lp_synchronise(&n->lp);
    ANNOUNCE(n, envelope, m, now);
    const struct order_policy *orders = order_policy_of(n);
    struct receive *r = orders ? orders->take_posted(n, m) : posted_take(n, &b->posted, m);
    if (r) {
        give(n, r, m);
        return true;
    }
    if (m->forced) {
        ANNOUNCE(n, loses, m, false, now);
        return false;
    }
    unexpected_add(n, m);
    if (m->is_long) /* others have arrived at once */
        lp_message_kept(&n->lp);
    if (m->in_order)
        lp_notify(&n->lp, now); /* a probe finds it before it is whole */
    if (m->is_long && (m->held || !room_for(n, m))) {
        b->waiting++;
        return false;
    }
    buffer(n, m);
    return true;
}

void match_arrived(void *ctx, struct message *m)
{
    struct node *n = node_at(ctx, m->to);
    struct receive *r = m->receive;
    if (r)
        r->complete = m->complete;
    else if (!m->unwanted)
        unexpected_has_arrived(n, m);
    ANNOUNCE(n, arrives, m);
    if (m->unwanted) {
        protocol_message_free(m);
    } else if (r && r->handler) {
        due_add(n, m->complete, r, NULL);
    } else {
        if (!r)
            lp_message_kept(&n->lp);
        lp_notify(&n->lp, m->complete);
    }
}

void match_sent(void *ctx, struct message *m, vtime now)
{
    struct node *n = node_at(ctx, m->from);
    struct send *s = m->send;
    m->followed = false;
    s->m = NULL;
    s->done = true;
    if (s->handler)
        due_add(n, now, NULL, s);
    else
        lp_notify(&n->lp, now);
}

void match_follow(struct message *m, struct send *s)
{
    m->send = s;
    m->followed = true;
    s->m = m;
}

void match_unfollow(struct send *s)
{
    if (s->m)
        s->m->followed = false;
}

/* --- sending --- */

vtime match_send_time(const struct node *n, const struct message *m)
{
    return node_system_time(n, protocol_send_time(n->sys->schedule.protocol, m->type, m->bytes));
}

vtime match_send_late(const struct node *n)
{
    struct timing *t = n->sys->timing;
    return __builtin_expect(t != NULL, 0) ? timing_next_message(t, node_timed(n)) : 0;
}

inline vtime match_send(struct node *n, struct message *first, vtime now)
{
    vtime begun = now, late = match_send_late(n);
    ANNOUNCE(n, hands_over, first, now + match_send_time(n, first), late);
    for (struct message *m = first, *next; m; m = next) {
        next = m->next;
        now += match_send_time(n, m);
        protocol_send_late(n->sys->schedule.protocol, m, now, late);
    }
    node_account(n, NODE_SENDING, now - begun);
    charge_in_kernel(n, now);
    return now;
}

/* --- receiving --- */

void match_select(struct node *n, struct receive *r, struct message *m, vtime now)
{
    unexpected_take(n, m);
    give(n, r, m);
    if (m->is_long && !m->cleared) {
        n->mailbox.waiting--;
        protocol_clear_to_send(m->protocol, m, now);
    }
    if (m->arrived && r->handler)
        due_add(n, vt_max(m->complete, now), r, NULL);
}

static inline struct message *first_unexpected(struct node *n, const struct receive *r)
{
    const struct order_policy *orders = order_policy_of(n);
    return orders ? orders->unexpected(n, r) : unexpected_first(n, &r->select);
}

void match_post(struct node *n, struct receive *r, vtime now)
{
    struct message *m = first_unexpected(n, r);
    charge_in_kernel(n, now);
    if (m)
        match_select(n, r, m, now);
    else
        posted_append(&n->mailbox.posted, r);
}

void match_put_back(struct node *n, struct message *m)
{
    m->receive = NULL;
    unexpected_put_back(n, m);
}

bool match_withdraw(struct node *n, struct receive *r)
{
    if (posted_remove(&n->mailbox.posted, r))
        return false;
    struct message *m = r->m;
    r->m = NULL;
    if (!m->buffered)
        buffer(n, m);
    match_put_back(n, m);
    return true;
}

void match_serve_posted(struct node *n, vtime now)
{
    for (struct receive *r = n->mailbox.posted.first, *next; r; r = next) {
        struct message *m = first_unexpected(n, r);
        next = r->next;
        if (m && posted_remove(&n->mailbox.posted, r))
            match_select(n, r, m, now);
    }
}

vtime match_copying(const struct node *n, const struct message *m)
{
    return m->buffered && !m->too_long ? m->bytes * n->sys->cfg->copy_ps_per_byte : 0;
}

inline void match_done_with(struct node *n, struct message *m, vtime now)
{
    charge_in_kernel(n, now);
    unbuffer(n, m, now);
    protocol_message_free(m);
}

/* Throws away a message that has been taken off the queue. */
static void throw_away(struct node *n, struct message *m, vtime now)
{
    m->unwanted = true;
    if (m->is_long && !m->cleared) {
        n->mailbox.waiting--;
        protocol_clear_to_send(m->protocol, m, now);
    }
    unbuffer(n, m, now);
    if (m->arrived)
        protocol_message_free(m);
}

static void throw_away_all(struct node *n, struct message *list, int64_t typesel, vtime now)
{
    for (struct message *m = list, *next; m; m = next) {
        next = m->next;
        if (!mailbox_selects(typesel, m->type))
            continue;
        ANNOUNCE(n, loses, m, true, now);
        unexpected_take(n, m);
        throw_away(n, m, now);
    }
}

void match_flush(struct node *n, int64_t typesel, vtime now)
{
    throw_away_all(n, n->mailbox.whole, typesel, now);
    throw_away_all(n, n->unexpected.coming, typesel, now);
}

/* --- when a program is gone --- */

/* No send follows m any more: the sender's program is gone. */
static void drop_send(struct message *m)
{
    struct send *s = m->followed ? m->send : NULL;
    m->followed = false;
    if (s)
        s->m = NULL;
    if (s && s->handler)
        free(s);
}

/* Nobody receives m any more, which has not arrived, and which a receive of the program had selected. */
static void drop_receive(struct message *m)
{
    struct receive *r = m->receive;
    m->receive = NULL;
    m->unwanted = true;
    r->m = NULL;
    if (r->handler)
        free(r);
}

void match_abandon(struct node *n)
{
    struct mailbox *b = &n->mailbox;
    for (struct message *m = protocol_from(n->sys->schedule.protocol, n->lp.address); m;
         m = protocol_next_from(m))
        drop_send(m);
    for (struct message *m = protocol_to(n->sys->schedule.protocol, n->lp.address); m;
         m = protocol_next_to(m))
        if (m->receive)
            drop_receive(m);
    ANNOUNCE(n, abandons);
    due_free(b);
    free_posted(b);
    posted_begin(&b->posted);
}

static void throw_away_list(struct node *n, struct message **list, vtime now)
{
    while (*list) {
        struct message *m = *list;
        unexpected_take(n, m);
        throw_away(n, m, now);
    }
}

void match_empty(struct node *n, vtime now)
{
    throw_away_list(n, &n->unexpected.coming, now);
    throw_away_list(n, &n->mailbox.whole, now);
    for (struct message *m = protocol_to(n->sys->schedule.protocol, n->lp.address); m;
         m = protocol_next_to(m))
        m->unwanted = m->unwanted || !m->serves;
}

void match_inherit(struct node *n, struct node *before)
{
    unexpected_inherit(n, before);
    n->mailbox.waiting = before->mailbox.waiting;
    n->memory.buffered = before->memory.buffered;
    node_memory_changed(n);
}

/* --- questions --- */

bool match_may_grant(const struct node *n)
{
    return n->mailbox.waiting > 0;
}

bool match_ignores(const struct node *n)
{
    return n->mailbox.ids.ignored > 0;
}
