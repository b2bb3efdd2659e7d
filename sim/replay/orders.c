/* orders.c - see orders.h. */
#include "replay/orders.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "nx_api/contract/matching.h"
#include "os/first_failure.h"
#include "replay/numbering.h"
#include "os/unexpected.h"

static const struct plan *plan_of(const struct node *n)
{
    return n->sys->numbering->plan;
}

static const struct plan_node *orders_of(const struct node *n)
{
    return &plan_of(n)->node[numbering_index(n->sys, n->lp.address)];
}

/* --- which message a receive gets --- */

/* The order about a message that has come to n; NULL: there is none. */
static const struct plan_item *order_of(const struct node *n, const struct message *m)
{
    return plan_find_message(&orders_of(n)->by_message, numbering_index(n->sys, m->source),
                             protocol_number_of(m)->nth);
}

static bool is_for(const struct plan_item *order, const struct numbered_receive *r)
{
    return order ? order->k == r->number : !r->order;
}

/* May r have m, if it selects it? */
static bool allows(const struct node *n, const struct receive *r, const struct message *m)
{
    return is_for(order_of(n, m), r->numbered);
}

/* A receive is there, and so is the message that it is to get, but it selects others. */
static void fail_to_select(struct node *n, const struct receive *r, const struct message *m)
{
    const struct numbered_receive *numbered = r->numbered;
    node_system_fail(
        n->sys, STOP_FAILED, n->sys->schedule.reached,
        "%s:%u: cannot be kept: receive %" PRIu64 " of %s (%s%s%s) does not select message %" PRIu64
        " from %s, which has type %" PRId32 " and %zu bytes: it selects typesel %" PRId64 ", node %ld",
        plan_of(n)->path, numbered->order->line, numbered->number, n->cold->name, numbered->call,
        numbered->line ? ", " : "", numbered->line ? numbered->line : "", protocol_number_of(m)->nth,
        node_at(n->sys, m->source)->cold->name, m->type, m->bytes, r->select.type, r->select.node);
}

static bool takes(struct node *n, const struct receive *r, const struct message *m)
{
    if (!allows(n, r, m))
        return false;
    if (matching_selects(n, &r->select, m))
        return true;
    if (r->numbered->order)
        fail_to_select(n, r, m);
    return false;
}

static struct receive *take_posted(struct node *n, const struct message *m)
{
    struct posted *p = &n->mailbox.posted;
    for (struct receive **link = &p->first; *link; link = &(*link)->next)
        if (takes(n, *link, m))
            return posted_unlink(p, link);
    return NULL;
}

static struct message *first_in(struct node *n, const struct receive *r, struct message *list)
{
    while (list && !takes(n, r, list))
        list = list->next;
    return list;
}

static struct message *first_unexpected(struct node *n, const struct receive *r)
{
    struct message *m = first_in(n, r, n->mailbox.whole);
    return m ? m : first_in(n, r, n->unexpected.coming);
}

/* --- probes --- */

/* The first selected message whose order, or want of one, is this. */
static struct message *first_of(const struct node *n, const struct selector *select,
                                const struct plan_item *order)
{
    struct message *const lists[] = {n->mailbox.whole, n->unexpected.coming};
    for (int i = 0; i < 2; i++)
        for (struct message *m = lists[i]; m; m = m->next) {
            const struct plan_item *of = order_of(n, m);
            if (matching_selects(n, select, m) && (order ? of && of->k == order->k : !of))
                return m;
        }
    return NULL;
}

static struct message *probe(const struct node *n, const struct selector *select)
{
    const struct plan_item *next = plan_find(&orders_of(n)->matches, numbering_node(n)->receives);
    struct message *m = next ? first_of(n, select, next) : NULL;
    return m ? m : first_of(n, select, NULL);
}

/* --- handlers --- */

/* The order about the handler that runs next; NULL: there is none. */
static const struct plan_item *next_handler(const struct node *n)
{
    return plan_find(&orders_of(n)->handlers, numbering_node(n)->handlers);
}

static bool lets_handler_run(const struct node *n)
{
    const struct plan_item *order = next_handler(n);
    return !order || numbering_node(n)->calls >= order->calls;
}

static bool lets_call_begin(const struct node *n)
{
    const struct plan_item *order = next_handler(n);
    return n->in_handler || !order || order->calls > numbering_node(n)->calls;
}

const struct order_policy orders_policy = {take_posted, first_unexpected, probe, lets_handler_run,
                                           lets_call_begin};

/* --- the end --- */

/* What became of a receive that is to get a message, and has not. */
static void tell_receive(FILE *f, const struct node_system *s, uint32_t index, const struct plan_item *order)
{
    const struct numbering *b = s->numbering;
    const struct numbered_node *own = &b->node[index];
    const char *from = order->from < b->nodes ? s->nodes[order->from]->cold->name : "host";
    const uint32_t *sent_to = b->node[order->from].sent_to;
    uint32_t sent = sent_to ? sent_to[index] : 0;
    if (own->receives <= order->k)
        fprintf(f, "it has made %" PRIu64 " receives", own->receives);
    else
        fprintf(f, "the receive was made, but has not got it");
    if (sent <= order->nth)
        fprintf(f, "; %s has sent it %u messages", from, sent);
    else
        fprintf(f, "; the message was sent");
}

/* The first of a node's matches, and handlers, that it has not kept; what follows on the node follows from
 * it. NULL: all are kept. */
static const struct plan_item *unkept_match(const struct numbering *b, uint32_t index)
{
    const struct plan_list *l = &b->plan->node[index].matches;
    for (size_t i = 0; i < l->count; i++)
        if (!b->node[index].kept[i])
            return &l->item[i];
    return NULL;
}

static const struct plan_item *unkept_handler(const struct numbering *b, uint32_t index)
{
    const struct plan_list *l = &b->plan->node[index].handlers;
    for (size_t i = 0; i < l->count; i++)
        if (l->item[i].k >= b->node[index].handlers)
            return &l->item[i];
    return NULL;
}

static bool tell_unkept(FILE *f, const struct node_system *s, uint32_t index)
{
    const struct numbering *b = s->numbering;
    const struct numbered_node *own = &b->node[index];
    const struct plan_item *match = unkept_match(b, index), *handler = unkept_handler(b, index);
    const char *name = index < b->nodes ? s->nodes[index]->cold->name : "host";
    if (match) {
        fprintf(f, "\n  %s:%u: not kept: receive %" PRIu64 " of %s: ", b->plan->path, match->line, match->k,
                name);
        tell_receive(f, s, index, match);
    }
    if (handler)
        fprintf(f,
                "\n  %s:%u: not kept: handler %" PRIu64 " of %s: %" PRIu64
                " handlers have run, after %" PRIu64 " calls",
                b->plan->path, handler->line, handler->k, name, own->handlers, own->calls);
    return match || handler;
}

char *orders_unkept(const struct node_system *s)
{
    enum { MOST_NODES = 8 };
    char *text;
    size_t size;
    if (!s->orders)
        return NULL;
    FILE *f = xchecked(open_memstream(&text, &size));
    unsigned told = 0;
    for (uint32_t i = 0; i <= s->numbering->nodes && told < MOST_NODES; i++)
        told += tell_unkept(f, s, i);
    fclose(f);
    if (*text)
        return text;
    free(text);
    return NULL;
}
