/* unexpected.c - see unexpected.h. The whole ones are linked both ways: one in their midst may be wanted. */
#include "node/unexpected.h"
#include "kernel/cache.h"
#include "node/system.h"

void unexpected_begin(struct node *n)
{
    n->mailbox.whole = n->coming = NULL;
    n->mailbox.whole_end = &n->mailbox.whole;
}

bool unexpected_selects(const struct node *n, const struct selector *select, const struct message *m)
{
    return mailbox_selects(select->type, m->type) &&
           (select->node < 0 || select->node == (long)node_number(n->sys, m->source)) &&
           (select->pid < 0 || select->pid == m->pid);
}

/* Are they found in the order in which they were sent? */
static bool keep_order(const struct message *a, const struct message *b)
{
    return a->type == b->type && a->source == b->source && a->pid == b->pid;
}

/* --- the whole --- */

static void link_whole(struct mailbox *b, struct message **link, struct message *m)
{
    m->whole = true;
    m->next = *link;
    m->whole_link = link;
    *link = m;
    if (m->next)
        m->next->whole_link = &m->next;
    else
        b->whole_end = &m->next;
}

static void unlink_whole(struct mailbox *b, struct message *m)
{
    m->whole = false;
    *m->whole_link = m->next;
    if (m->next)
        m->next->whole_link = m->whole_link;
    else
        b->whole_end = m->whole_link;
}

/* --- the coming --- */

static struct message **end_of(struct message **list)
{
    while (*list)
        list = &(*list)->next;
    return list;
}

static void link_coming(struct message **link, struct message *m)
{
    m->next = *link;
    *link = m;
}

static struct message *unlink_coming(struct message **link)
{
    struct message *m = *link;
    *link = m->next;
    return m;
}

/* The first from a link on that m comes before or behind. */
static struct message **of_same_order(struct message **link, const struct message *m)
{
    while (*link && !keep_order(*link, m))
        link = &(*link)->next;
    return link;
}

/* --- */

void unexpected_add(struct node *n, struct message *m)
{
    link_coming(end_of(&n->coming), m);
}

/* Whole are now those that m comes before or behind, m among them, up to the next that has not arrived. */
void unexpected_has_arrived(struct node *n, const struct message *m)
{
    struct mailbox *b = &n->mailbox;
    struct message **link = of_same_order(&n->coming, m);
    while (*link && (*link)->arrived) {
        link_whole(b, b->whole_end, unlink_coming(link));
        link = of_same_order(link, m);
    }
}

struct message *unexpected_first(const struct node *n, const struct selector *select)
{
    struct message *m = n->mailbox.whole;
    while (m && !unexpected_selects(n, select, m))
        m = m->next;
    if (m)
        return m;
    for (m = n->coming; m && !unexpected_selects(n, select, m);)
        m = m->next;
    return m;
}

void unexpected_take(struct node *n, struct message *m)
{
    if (m->whole) {
        cache_load(m->next); /* often the next to be asked for */
        unlink_whole(&n->mailbox, m);
        return;
    }
    struct message **link = &n->coming;
    while (*link != m)
        link = &(*link)->next;
    unlink_coming(link);
    unexpected_has_arrived(n, m); /* they need not wait for it any more */
}

/* m is the first to come, and before those that are whole and were sent behind it. */
static void put_before_whole(struct node *n, struct message *m)
{
    struct message **behind = &m->next;
    link_coming(&n->coming, m);
    for (struct message *w = n->mailbox.whole, *next; w; w = next) {
        next = w->next;
        if (!keep_order(w, m))
            continue;
        unlink_whole(&n->mailbox, w);
        link_coming(behind, w);
        behind = &w->next;
    }
}

void unexpected_put_back(struct node *n, struct message *m)
{
    if (m->arrived)
        link_whole(&n->mailbox, &n->mailbox.whole, m);
    else
        put_before_whole(n, m);
}

void unexpected_inherit(struct node *n, struct node *before)
{
    n->coming = before->coming;
    for (struct message *m = before->mailbox.whole, *next; m; m = next) {
        next = m->next;
        link_whole(&n->mailbox, n->mailbox.whole_end, m);
    }
    unexpected_begin(before);
}
