/* unexpected.c - see unexpected.h. The whole messages are linked both ways, since a receive may take one from
 * their midst. Many of them are indexed by type, too, so that a receive need not look at messages of other
 * types. */
#include "os/unexpected.h"
#include "kernel/prefetch.h"
#include "kernel/queues.h"
#include "node/system.h"
#include "nx_api/contract/matching.h"

void unexpected_begin(struct node *n)
{
    n->mailbox.whole = n->unexpected.coming = NULL;
    n->mailbox.whole_end = &n->mailbox.whole;
    n->unexpected.by_type = NULL;
    n->unexpected.count = 0, n->unexpected.order = 0;
}

void unexpected_end(struct node *n)
{
    queues_free(n->unexpected.by_type);
}

/* Must a and b be found in the order in which they were sent? (MPI's rule has no regard to types.) */
static bool keep_order(const struct message *a, const struct message *b)
{
    return a->source == b->source && a->pid == b->pid && (a->type == b->type || (a->in_order && b->in_order));
}

/* --- the whole --- */

/* Up to so many messages are searched one by one: they fill a few lines of the cache. */
enum { FEW_WHOLE = 32 };

/* Makes the index of the messages that are there. */
static void begin_types(struct node *n)
{
    n->unexpected.by_type = queues_new();
    for (struct message *m = n->mailbox.whole; m; m = m->next)
        queues_add(n->unexpected.by_type, (uint32_t)m->type, ++n->unexpected.order, m);
}

static void link_whole(struct node *n, struct message **link, struct message *m)
{
    m->whole = true;
    m->next = *link;
    m->whole_link = link;
    *link = m;
    if (m->next)
        m->next->whole_link = &m->next;
    else
        n->mailbox.whole_end = &m->next;
}

static void append_whole(struct node *n, struct message *m)
{
    link_whole(n, n->mailbox.whole_end, m);
    if (n->unexpected.by_type)
        queues_add(n->unexpected.by_type, (uint32_t)m->type, ++n->unexpected.order, m);
    if (++n->unexpected.count > FEW_WHOLE && !n->unexpected.by_type)
        begin_types(n);
}

static void remove_whole(struct node *n, struct message *m)
{
    m->whole = false;
    *m->whole_link = m->next;
    if (m->next)
        m->next->whole_link = m->whole_link;
    else
        n->mailbox.whole_end = m->whole_link;
    if (n->unexpected.by_type)
        queues_remove(n->unexpected.by_type, (uint32_t)m->type, m);
    if (--n->unexpected.count == 0) {
        queues_free(n->unexpected.by_type);
        n->unexpected.by_type = NULL;
    }
}

static __attribute__((noinline)) struct message *first_of_type(const struct node *n,
                                                               const struct selector *select)
{
    for (uint32_t i = 0;; i++) {
        struct message *m = queues_at(n->unexpected.by_type, (uint32_t)select->type, i);
        if (!m || matching_selects(n, select, m))
            return m;
    }
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

/* The first link, from one on, to a message that m has an order with. */
static struct message **of_same_order(struct message **link, const struct message *m)
{
    while (*link && !keep_order(*link, m))
        link = &(*link)->next;
    return link;
}

/* --- */

void unexpected_add(struct node *n, struct message *m)
{
    link_coming(end_of(&n->unexpected.coming), m);
}

/* Makes whole the messages that m has an order with, m among them, up to the first that has not arrived. */
inline void unexpected_has_arrived(struct node *n, const struct message *m)
{
    struct message **link = of_same_order(&n->unexpected.coming, m);
    while (*link && (*link)->arrived) {
        append_whole(n, unlink_coming(link));
        link = of_same_order(link, m);
    }
}

struct message *unexpected_first(const struct node *n, const struct selector *select)
{
    if (!n->mailbox.whole && !n->unexpected.coming)
        return NULL; /* as most often */
    bool one_type = n->unexpected.by_type && select->type >= 0 && select->type <= INT32_MAX;
    struct message *m = one_type ? first_of_type(n, select) : matching_first(n, select, n->mailbox.whole);
    return m ? m : matching_first(n, select, n->unexpected.coming);
}

void unexpected_take(struct node *n, struct message *m)
{
    if (m->whole) {
        prefetch_pair(m->next); /* a receive often asks for it next */
        remove_whole(n, m);
        return;
    }
    struct message **link = &n->unexpected.coming;
    while (*link != m)
        link = &(*link)->next;
    unlink_coming(link);
    unexpected_has_arrived(n, m); /* those behind m need not wait for it any more */
}

/* --- messages that come back --- */

/* When the system had handled m's envelope, which it does in the order in which envelopes come. (A long
 * message that carries a cargo does not tell: it counts as first until it has arrived.) */
static vtime handled(const struct message *m)
{
    bool tells = m->is_long && !m->carries;
    return tells ? m->asked : m->arrived ? m->complete : 0;
}

/* Has w an order with m, and was sent earlier? */
static bool is_before(const struct message *w, const struct message *m)
{
    return keep_order(w, m) && handled(w) < handled(m);
}

/* Puts m back before the whole messages that came whole after it, or were sent after it. */
static void put_back_whole(struct node *n, struct message *m)
{
    struct message **link = &n->mailbox.whole;
    for (struct message *w = *link; w; w = w->next)
        if (is_before(w, m))
            link = &w->next;
    while (*link && (*link)->complete < m->complete && !keep_order(*link, m))
        link = &(*link)->next;
    link_whole(n, link, m);
    n->unexpected.count++;
    if (!n->unexpected.by_type)
        return;
    queues_free(n->unexpected.by_type);
    begin_types(n);
}

/* Puts m back among the coming, and with it the whole messages that were sent after it. */
static void put_back_coming(struct node *n, struct message *m)
{
    struct message **link = &n->unexpected.coming;
    while (*link && handled(*link) < handled(m))
        link = &(*link)->next;
    link_coming(link, m);
    for (struct message *w = n->mailbox.whole, *next; w; w = next) {
        next = w->next;
        if (!keep_order(w, m) || is_before(w, m))
            continue;
        remove_whole(n, w);
        while (*link && handled(*link) <= handled(w))
            link = &(*link)->next;
        link_coming(link, w);
    }
}

void unexpected_put_back(struct node *n, struct message *m)
{
    bool waits = !m->arrived;
    for (const struct message *c = n->unexpected.coming; c && !waits; c = c->next)
        waits = is_before(c, m);
    if (waits)
        put_back_coming(n, m);
    else
        put_back_whole(n, m);
}

void unexpected_inherit(struct node *n, struct node *before)
{
    n->unexpected.coming = before->unexpected.coming;
    for (struct message *m = before->mailbox.whole, *next; m; m = next) {
        next = m->next;
        append_whole(n, m);
    }
    unexpected_end(before);
    unexpected_begin(before);
}
