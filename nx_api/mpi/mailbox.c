/* mailbox.c - see mailbox.h. */
#include "nx_api/mpi/mailbox.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include "nx_api/calls/mailbox_ids.h"
#include "nx_api/mpi/tick.h"

/* A handler that is to run: for a receive that is complete, or a send whose buffer is free. */
struct due {
    struct receive *receive;
    struct send *send;
    struct due *next;
};

struct mailbox {
    struct receive *posted, **posted_end;
    struct message *unexpected, **unexpected_end;
    struct due *due, **due_end;
    uint32_t handlers; /* posted or due */
    struct mailbox_ids ids;
    struct id_block first_ids;
};

static void *must(void *p)
{
    if (!p)
        node_fail(node_self(), "out of memory");
    return p;
}

struct mailbox *mailbox_new(void)
{
    struct mailbox *b = must(aligned_alloc(_Alignof(struct mailbox), sizeof *b));
    *b = (struct mailbox){0};
    ids_begin(&b->ids, &b->first_ids);
    b->posted_end = &b->posted;
    b->unexpected_end = &b->unexpected;
    b->due_end = &b->due;
    return b;
}

struct mailbox_ids *mailbox_ids(const struct node *n)
{
    return &n->mailbox->ids;
}

static bool selects(const struct selector *s, const struct message *m)
{
    return mailbox_selects(s->type, m->type) && (s->node < 0 || s->node == (long)m->source) &&
           (s->pid < 0 || s->pid == m->pid);
}

static void message_free(struct message *m)
{
    free(m->block);
    free(m);
}

/* --- queues --- */

static void unpost(struct mailbox *b, struct receive **link)
{
    struct receive *r = *link;
    *link = r->next;
    if (b->posted_end == &r->next)
        b->posted_end = link;
}

static void unkeep(struct mailbox *b, struct message **link)
{
    struct message *m = *link;
    *link = m->next;
    if (b->unexpected_end == &m->next)
        b->unexpected_end = link;
}

static void add_due(struct mailbox *b, struct receive *r, struct send *s)
{
    struct due *d = must(calloc(1, sizeof *d));
    d->receive = r, d->send = s;
    *b->due_end = d;
    b->due_end = &d->next;
}

static void give(struct mailbox *b, struct receive *r, struct message *m)
{
    r->m = m;
    if (r->handler)
        add_due(b, r, NULL);
}

/* --- messages come in --- */

void mailbox_deliver(struct node *n, struct message *m)
{
    enum { FORCED = 1 << 30 };
    struct mailbox *b = n->mailbox;
    for (struct receive **link = &b->posted; *link; link = &(*link)->next) {
        struct receive *r = *link;
        if (!selects(&r->select, m))
            continue;
        unpost(b, link);
        give(b, r, m);
        return;
    }
    if (m->type >= FORCED || n->over) {
        message_free(m);
        return;
    }
    m->next = NULL;
    *b->unexpected_end = m;
    b->unexpected_end = &m->next;
}

void mailbox_flush(struct node *n, int64_t typesel)
{
    struct message **link = &n->mailbox->unexpected;
    while (*link) {
        struct message *m = *link;
        if (!mailbox_selects(typesel, m->type)) {
            link = &m->next;
            continue;
        }
        unkeep(n->mailbox, link);
        message_free(m);
    }
}

/* --- receiving --- */

void mailbox_post(struct node *n, struct receive *r)
{
    struct mailbox *b = n->mailbox;
    for (struct message **link = &b->unexpected; *link; link = &(*link)->next) {
        struct message *m = *link;
        if (!selects(&r->select, m))
            continue;
        unkeep(b, link);
        give(b, r, m);
        return;
    }
    r->next = NULL;
    *b->posted_end = r;
    b->posted_end = &r->next;
}

void mailbox_withdraw(struct node *n, struct receive *r)
{
    struct mailbox *b = n->mailbox;
    for (struct receive **link = &b->posted; *link; link = &(*link)->next)
        if (*link == r) {
            unpost(b, link);
            return;
        }
    struct message *m = r->m;
    r->m = NULL;
    m->next = b->unexpected;
    if (!b->unexpected)
        b->unexpected_end = &m->next;
    b->unexpected = m;
}

bool mailbox_complete(struct node *n, const struct receive *r)
{
    (void)n;
    return r->m;
}

void mailbox_tell(struct node *n, const struct message *m, long info[])
{
    n->info = (struct node_info){m->type, (long)m->bytes, m->source, m->pid};
    const long told[] = {n->info.type, n->info.count, n->info.node, n->info.pid};
    for (size_t i = 0; info && i < sizeof told / sizeof *told; i++)
        node_put_long(n, info, i, told[i]);
}

long mailbox_take(struct node *n, struct receive *r)
{
    struct message *m = r->m;
    long result = 0;
    if (m->bytes > r->room)
        result = node_error(n, EQMSGLONG,
                            "the message of type %ld from node %u has %zu bytes, but the buffer only %zu",
                            m->type, m->source, m->bytes, r->room);
    else if (m->bytes)
        memcpy(r->buf, m->data, m->bytes);
    if (!mailbox_is_library(m->type))
        mailbox_tell(n, m, r->info);
    message_free(m);
    r->m = NULL;
    return result;
}

const struct message *mailbox_probe(struct node *n, const struct selector *select)
{
    const struct message *m = n->mailbox->unexpected;
    while (m && !selects(select, m))
        m = m->next;
    return m;
}

void mailbox_drop(struct receive *r)
{
    if (r->m)
        message_free(r->m);
}

void mailbox_unfollow(struct send *s)
{
    (void)s; /* a send is done at once: the message is a copy */
}

/* --- handlers --- */

static void count_handlers(struct mailbox *b, int change)
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

/* Its buffer is free when the call has copied it. */
struct send *mailbox_send_handler(struct node *n, mailbox_handler *handler, long param)
{
    struct send *s = must(calloc(1, sizeof *s));
    s->handler = handler, s->param = param;
    count_handlers(n->mailbox, 1);
    add_due(n->mailbox, NULL, s);
    return s;
}

static void call_handler(struct node *n, const struct due *d)
{
    mailbox_handler *handler = d->receive ? d->receive->handler : d->send->handler;
    long param = d->receive ? d->receive->param : d->send->param;
    if (d->send)
        n->info = d->send->info;
    else if (mailbox_take(n, d->receive) < 0)
        node_fail(n, "hrecv: %s", n->error->text);
    free(d->receive);
    free(d->send);
    handler(n->info.type, n->info.count, n->info.node, n->info.pid, param);
}

bool mailbox_run_handler(struct node *n)
{
    struct mailbox *b = n->mailbox;
    if (!b->due || n->masked || n->in_handler)
        return false;
    struct due d = *b->due;
    struct node_info info = n->info;
    const char *call = n->call;
    long type = n->call_type;
    bool has_type = n->call_has_type;
    int saved_errno = n->saved_errno;
    free(b->due);
    b->due = d.next;
    if (!b->due)
        b->due_end = &b->due;
    count_handlers(b, -1);
    n->in_handler = true;
    n->call = NULL;
    call_handler(n, &d);
    n->in_handler = false;
    n->call = call, n->call_type = type, n->call_has_type = has_type;
    n->info = info;
    n->saved_errno = saved_errno;
    return true;
}
