/* numbering.c - see numbering.h. */
#include "replay/numbering.h"
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "os/due.h"
#include "os/observer.h"
#include "os/order.h"
#include "replay/schedule_record.h"

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

static void hear_call_acts(struct observer *o, struct node *n)
{
    (void)o;
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

static void hear_hands_over(struct observer *o, struct node *n, const struct message *first, vtime t,
                            vtime late)
{
    (void)o;
    number_all(n, first, numbering_node(n)->sends++, t);
    if (is_recorded(n))
        schedule_record_send(n, first, late);
}

static void hear_envelope(struct observer *o, struct node *n, const struct message *m, vtime t)
{
    (void)o, (void)n;
    protocol_number_of(m)->came = t;
}

/* --- receives --- */

static void hear_posts(struct observer *o, struct node *n, struct receive *r)
{
    (void)o;
    const struct numbering *b = n->sys->numbering;
    struct numbered_node *own = numbering_node(n);
    struct numbered_receive *noted = xcalloc(1, sizeof *noted);
    *noted = (struct numbered_receive){.number = own->receives++,
                                       .select = r->select,
                                       .posted = node_now(n),
                                       .call = n->call.name,
                                       .link = own->end};
    noted->line = b->line ? b->line(b->line_ctx, n, (uintptr_t)__builtin_frame_address(0)) : NULL;
    if (b->plan)
        noted->order =
            plan_find(&b->plan->node[numbering_index(n->sys, n->lp.address)].matches, noted->number);
    *own->end = noted, own->end = &noted->next;
    r->numbered = noted;
}

static void hear_gives(struct observer *o, struct node *n, const struct receive *r, const struct message *m)
{
    (void)o;
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

static void hear_withdraws(struct observer *o, struct node *n, struct receive *r)
{
    (void)o;
    drop(numbering_node(n), r->numbered);
    r->numbered = NULL;
}

static void hear_takes(struct observer *o, struct node *n, struct receive *r)
{
    if (is_recorded(n))
        schedule_record_match(n, r->numbered, node_now(n));
    hear_withdraws(o, n, r);
}

/* --- handlers --- */

static void hear_handler_due(struct observer *o, struct node *n, vtime t, vtime late)
{
    (void)o;
    uint64_t k = numbering_node(n)->interrupts++;
    if (late && is_recorded(n))
        schedule_record_interrupt(n, k, t, late);
}

static void hear_handler_begins(struct observer *o, struct node *n, const struct due *d)
{
    (void)o;
    const struct numbering *b = n->sys->numbering;
    uint64_t k = numbering_node(n)->handlers++;
    if (is_recorded(n))
        schedule_record_handler(n, k, d->at, d->receive ? d->receive->numbered : NULL,
                                b->line ? b->line(b->line_ctx, n, (uintptr_t)__builtin_frame_address(0))
                                        : NULL);
}

/* --- the end --- */

void numbering_over(struct node *n)
{
    struct numbered_node *own = numbering_node(n);
    while (own->first) {
        if (own->first->given && is_recorded(n))
            schedule_record_match(n, own->first, VT_NEVER);
        drop(own, own->first);
    }
}

static void hear_abandons(struct observer *o, struct node *n)
{
    (void)o;
    numbering_over(n);
}

/* --- the observer --- */

static const struct announcements heard = {.in_order = true,
                                           .call_acts = hear_call_acts,
                                           .hands_over = hear_hands_over,
                                           .envelope = hear_envelope,
                                           .posts = hear_posts,
                                           .gives = hear_gives,
                                           .withdraws = hear_withdraws,
                                           .takes = hear_takes,
                                           .handler_due = hear_handler_due,
                                           .handler_begins = hear_handler_begins,
                                           .abandons = hear_abandons};

void numbering_begin(struct node *n)
{
    struct observer *o = xcalloc(1, sizeof *o);
    o->hears = &heard;
    observer_add(n, o);
}

void numbering_end(struct node *n)
{
    struct observer *o = observer_of(n, &heard);
    observer_remove(n, o);
    free(o);
}
