/* mpi_mailbox.c - see mpi_mailbox.h. */
#include "nx_api/mpi/mpi_mailbox.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include "nx_api/calls/msgwait.h"
#include "nx_api/calls/receive.h"
#include "nx_api/contract/ids.h"
#include "nx_api/contract/matching.h"
#include "nx_api/mpi/mpi_wire.h"
#include "nx_api/mpi/past_messages.h"
#include "nx_api/mpi/order_record.h"
#include "nx_api/mpi/run_summary.h"
#include "nx_api/mpi/tick.h"

/* A handler that is to run: for a receive that is complete, or a send whose buffer is free. */
struct mpi_due {
    struct receive *receive;
    struct send *send;
    struct mpi_due *next;
};

struct mpi_mailbox {
    struct posted posted;
    struct message *unexpected, **unexpected_end;
    struct mpi_due *due, **due_end;
    uint64_t come;     /* messages, so far */
    uint32_t handlers; /* posted or due */
    struct mailbox_ids ids;
};

static void *must(void *p)
{
    if (!p)
        node_fail(node_self(), "out of memory");
    return p;
}

struct mpi_mailbox *mpi_mailbox_new(void)
{
    struct mpi_mailbox *b = must(aligned_alloc(_Alignof(struct mpi_mailbox), sizeof *b));
    *b = (struct mpi_mailbox){0};
    posted_begin(&b->posted);
    b->unexpected_end = &b->unexpected;
    b->due_end = &b->due;
    return b;
}

struct mailbox_ids *mailbox_ids(const struct node *n)
{
    return &n->mailbox->ids;
}

long nx_sender(const struct node *n, const struct message *m)
{
    (void)n;
    return m->source;
}

/* For the caller's error message: overwritten by the next call. */
const char *nx_sender_name(const struct node *n, const struct message *m)
{
    static char name[24];
    (void)n;
    snprintf(name, sizeof name, "node %u", m->source);
    return name;
}

/* MPI may still be receiving its bytes. */
static void message_lose(struct message *m)
{
    if (m->whole)
        wire_free(m);
    else
        m->lost = true;
}

/* --- queues --- */

static void unkeep(struct mpi_mailbox *b, struct message **link)
{
    struct message *m = *link;
    *link = m->next;
    if (b->unexpected_end == &m->next)
        b->unexpected_end = link;
}

static void add_due(struct mpi_mailbox *b, struct receive *r, struct send *s)
{
    struct mpi_due *d = must(calloc(1, sizeof *d));
    d->receive = r, d->send = s;
    *b->due_end = d;
    b->due_end = &d->next;
}

static void give(struct mpi_mailbox *b, struct receive *r, struct message *m)
{
    r->m = m;
    m->taker = r;
    RECORD_ORDER(match, r, m);
    if (r->handler && m->whole)
        add_due(b, r, NULL);
}

/* --- messages come in --- */

void mpi_mailbox_deliver(struct node *n, struct message *m)
{
    enum { FORCED = 1 << 30 };
    struct mpi_mailbox *b = n->mailbox;
    m->come = b->come++;
    struct receive *r = posted_take(n, &b->posted, m);
    if (r) {
        give(b, r, m);
        return;
    }
    if (m->type >= FORCED || n->over) {
        past_lost(WAITFOR_DISCARDED, m);
        message_lose(m);
        return;
    }
    m = wire_keep(n, m);
    m->next = NULL;
    *b->unexpected_end = m;
    b->unexpected_end = &m->next;
}

void mpi_mailbox_whole(struct node *n, struct message *m)
{
    m->whole = true;
    if (m->lost)
        wire_free(m);
    else if (m->taker && m->taker->handler)
        add_due(n->mailbox, m->taker, NULL);
}

void *mpi_mailbox_place(const struct message *m)
{
    const struct receive *r = m->taker;
    return r && m->bytes <= r->room ? r->buf : NULL;
}

void mpi_mailbox_flush(struct node *n, int64_t typesel)
{
    for (struct message **link = &n->mailbox->unexpected, *m; (m = *link);) {
        if (!mailbox_selects(typesel, m->type)) {
            link = &m->next;
            continue;
        }
        unkeep(n->mailbox, link);
        past_lost(WAITFOR_FLUSHED, m);
        message_lose(m);
    }
}

/* --- receiving --- */

static void give_unexpected(struct mpi_mailbox *b, struct receive *r, struct message *m)
{
    struct message **link = &b->unexpected;
    while (*link != m)
        link = &(*link)->next;
    unkeep(b, link);
    give(b, r, m);
}

void mailbox_post(struct node *n, struct receive *r)
{
    struct mpi_mailbox *b = n->mailbox;
    struct message *m = matching_first(n, &r->select, b->unexpected);
    r->place = n->call.caller;
    RECORD_ORDER(receive, r);
    past_receive(n, r);
    if (m)
        give_unexpected(b, r, m);
    else
        posted_append(&b->posted, r);
}

void mailbox_serve_posted(struct node *n)
{
    struct mpi_mailbox *b = n->mailbox;
    for (struct receive *r = b->posted.first, *next; r; r = next) {
        struct message *m = matching_first(n, &r->select, b->unexpected);
        next = r->next;
        if (m && posted_remove(&b->posted, r))
            give_unexpected(b, r, m);
    }
}

bool mailbox_withdraw(struct node *n, struct receive *r)
{
    struct mpi_mailbox *b = n->mailbox;
    if (posted_remove(&b->posted, r))
        return false;
    struct message *m = r->m;
    r->m = NULL;
    m->taker = NULL;
    m = wire_keep(n, m);
    RECORD_ORDER(withdraw, r);
    struct message **link = &b->unexpected;
    while (*link && (*link)->come < m->come)
        link = &(*link)->next;
    m->next = *link;
    if (!m->next)
        b->unexpected_end = &m->next;
    *link = m;
    return true;
}

bool mailbox_complete(struct node *n, const struct receive *r)
{
    (void)n;
    return r->m && r->m->whole;
}

long mailbox_take(struct node *n, struct receive *r)
{
    long result = matching_take(n, r);
    if (past_matters(n, r))
        past_taken(n, r);
    wire_free(r->m);
    r->m = NULL;
    return result;
}

const struct message *mailbox_probe(struct node *n, const struct selector *select)
{
    const struct message *m = matching_first(n, select, n->mailbox->unexpected);
    return m && m->whole ? m : NULL;
}

void mailbox_drop(struct receive *r)
{
    if (r->m)
        message_lose(r->m);
}

void mailbox_unfollow(struct send *s)
{
    (void)s; /* no message is linked: a send is done at once, since the message is a copy */
}

/* --- handlers --- */

static void count_handlers(struct mpi_mailbox *b, int change)
{
    b->handlers += (uint32_t)change;
    tick_often(b->handlers > 0);
}

void mailbox_post_handler(struct node *n, const struct receive *what)
{
    struct receive *r = must(calloc(1, sizeof *r));
    *r = *what;
    count_handlers(n->mailbox, 1);
    mailbox_post(n, r);
}

/* Due at once: the buffer is free when the call has copied it. */
struct send *mailbox_send_handler(struct node *n, mailbox_handler *handler, long param)
{
    struct send *s = must(calloc(1, sizeof *s));
    s->handler = handler, s->param = param;
    count_handlers(n->mailbox, 1);
    add_due(n->mailbox, NULL, s);
    return s;
}

static void call_handler(struct node *n, const struct mpi_due *d)
{
    mailbox_handler *handler = d->receive ? d->receive->handler : d->send->handler;
    long param = d->receive ? d->receive->param : d->send->param;
    if (d->send)
        n->info = d->send->info;
    else if (mailbox_take(n, d->receive) < 0)
        node_fail(n, "hrecv: %s", n->error.text);
    free(d->receive);
    free(d->send);
    handler(n->info.type, n->info.count, n->info.node, n->info.pid, param);
}

bool mpi_mailbox_run_handler(struct node *n)
{
    struct mpi_mailbox *b = n->mailbox;
    if (!b->due || n->masked || n->in_handler)
        return false;
    struct mpi_due d = *b->due;
    struct node_info info = n->info;
    struct mpi_call call = n->call;
    int saved_errno = n->saved_errno;
    bool (*ready)(struct node *, void *) = n->ready;
    free(b->due);
    b->due = d.next;
    if (!b->due)
        b->due_end = &b->due;
    count_handlers(b, -1);
    RECORD_ORDER(handler);
    n->in_handler = true;
    n->call.name = NULL;
    n->ready = NULL;
    SUMMARY(handler);
    call_handler(n, &d);
    SUMMARY(handled);
    n->in_handler = false;
    n->ready = ready;
    n->call = call;
    n->info = info;
    n->saved_errno = saved_errno;
    return true;
}

/* --- for reports --- */

const struct message *mpi_mailbox_unexpected(const struct node *n)
{
    return n->mailbox->unexpected;
}

const struct receive *mpi_mailbox_posted(const struct node *n)
{
    return n->mailbox->posted.first;
}

bool mpi_mailbox_due(const struct node *n, unsigned i, const struct receive **r)
{
    const struct mpi_due *d = n->mailbox->due;
    for (; d && i; i--)
        d = d->next;
    *r = d ? d->receive : NULL;
    return d;
}
