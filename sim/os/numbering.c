/* numbering.c - see numbering.h. */
#include "os/numbering.h"
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "os/order.h"
#include "os/schedule_record.h"

struct numbering *numbering_new(uint32_t nodes, const struct plan *orders, FILE *out)
{
    struct numbering *b = xcalloc(1, sizeof *b + (nodes + 1) * sizeof *b->node);
    b->plan = orders, b->out = out, b->nodes = nodes;
    for (uint32_t i = 0; i <= nodes; i++) {
        b->node[i].end = &b->node[i].first;
        if (orders)
            b->node[i].kept = xcalloc(orders->node[i].matches.count, sizeof *b->node[i].kept);
    }
    return b;
}

/* Takes a receive off its node's list. */
static void drop(struct numbered_node *b, struct numbered_receive *r)
{
    *r->link = r->next;
    if (r->next)
        r->next->link = r->link;
    else
        b->end = r->link;
    free(r);
}

void numbering_free(struct numbering *b)
{
    for (uint32_t i = 0; b && i <= b->nodes; i++) {
        while (b->node[i].first)
            drop(&b->node[i], b->node[i].first);
        free(b->node[i].sent_to);
        free(b->node[i].kept);
    }
    free(b);
}

uint32_t numbering_index(const struct node_system *s, uint32_t address)
{
    return topo_is_host(&s->topo, address) ? s->numbering->nodes : address;
}

struct numbered_node *numbering_node(const struct node *n)
{
    return &n->sys->numbering->node[numbering_index(n->sys, n->lp.address)];
}

static bool is_recorded(const struct node *n)
{
    return n->sys->numbering->out;
}

void number_call(struct node *n)
{
    if (!n->in_handler)
        numbering_node(n)->calls++;
}

/* --- messages --- */

static void number_one(struct node *n, const struct message *m, uint64_t index, vtime t)
{
    const struct numbering *b = n->sys->numbering;
    struct numbered_node *from = numbering_node(n);
    if (!from->sent_to)
        from->sent_to = xcalloc(b->nodes + 1, sizeof *from->sent_to);
    *protocol_number_of(m) = (struct message_number){
        .index = index, .nth = from->sent_to[numbering_index(n->sys, m->to)]++, .sent = t, .came = VT_NEVER};
}

/* And those that are forwarded. */
static void number_all(struct node *n, const struct message *m, uint64_t index, vtime t)
{
    for (; m; m = m->next) {
        number_one(n, m, index, t);
        number_all(n, protocol_forwards(m), index, t);
    }
}

void number_send(struct node *n, const struct message *first, vtime t, vtime late)
{
    number_all(n, first, numbering_node(n)->sends++, t);
    if (is_recorded(n))
        schedule_record_send(n, first, late);
}

void number_came(struct node *n, const struct message *m, vtime now)
{
    (void)n;
    protocol_number_of(m)->came = now;
}

/* --- receives --- */

void number_post(struct node *n, struct receive *r, vtime now)
{
    const struct numbering *b = n->sys->numbering;
    struct numbered_node *own = numbering_node(n);
    struct numbered_receive *noted = xcalloc(1, sizeof *noted);
    *noted = (struct numbered_receive){
        .number = own->receives++, .select = r->select, .posted = now, .call = n->call, .link = own->end};
    noted->line = b->line ? b->line(b->line_ctx, n, (uintptr_t)__builtin_frame_address(0)) : NULL;
    if (b->plan)
        noted->order =
            plan_find(&b->plan->node[numbering_index(n->sys, n->lp.address)].matches, noted->number);
    *own->end = noted, own->end = &noted->next;
    r->numbered = noted;
}

void number_give(struct node *n, const struct receive *r, const struct message *m)
{
    struct numbered_receive *noted = r->numbered;
    struct numbered_node *own = numbering_node(n);
    noted->given = true;
    noted->from = numbering_index(n->sys, m->source);
    noted->type = m->type, noted->bytes = m->bytes;
    noted->message = *protocol_number_of(m);
    if (noted->order)
        own->kept[noted->order - n->sys->numbering->plan->node[own - n->sys->numbering->node].matches.item] =
            true;
}

void number_withdraw(struct node *n, struct receive *r)
{
    drop(numbering_node(n), r->numbered);
    r->numbered = NULL;
}

void number_take(struct node *n, struct receive *r)
{
    if (is_recorded(n))
        schedule_record_match(n, r->numbered, node_now(n));
    number_withdraw(n, r);
}

/* --- handlers --- */

void number_due(struct node *n, vtime due, vtime late)
{
    uint64_t k = numbering_node(n)->interrupts++;
    if (late && is_recorded(n))
        schedule_record_interrupt(n, k, due, late);
}

void number_handler(struct node *n, vtime due, const struct receive *r)
{
    const struct numbering *b = n->sys->numbering;
    uint64_t k = numbering_node(n)->handlers++;
    if (is_recorded(n))
        schedule_record_handler(n, k, due, r ? r->numbered : NULL,
                                b->line ? b->line(b->line_ctx, n, (uintptr_t)__builtin_frame_address(0))
                                        : NULL);
}

/* --- the end --- */

void number_end(struct node *n)
{
    struct numbered_node *own = numbering_node(n);
    while (own->first) {
        if (own->first->given && is_recorded(n))
            schedule_record_match(n, own->first, VT_NEVER);
        drop(own, own->first);
    }
}
