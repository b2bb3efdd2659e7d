/* matching.h - the rules by which messages and receives find each other, once for all back ends.
 *
 *   a message comes:    the first posted receive that selects it takes it; else it is unexpected
 *   a receive is made:  it takes the first unexpected message that it selects; else it is posted
 *   a probe is made:    it finds the message that a receive with its selector would take
 *
 * To be included behind the back end's definition of struct message, whose members next, type, pid, bytes and
 * data are used.
 */
#ifndef CONTRACT_MATCHING_H
#define CONTRACT_MATCHING_H
#include <string.h>
#include "nx_api/contract/backend.h"
#include "nx_api/include/nxerrno.h"

static inline bool matching_selects(const struct node *n, const struct selector *s, const struct message *m)
{
    return mailbox_selects(s->type, m->type) && (s->node < 0 || s->node == nx_sender(n, m)) &&
           (s->pid < 0 || s->pid == m->pid);
}

/* The first selected of a list of messages, linked by next; NULL: none. */
static inline struct message *matching_first(const struct node *n, const struct selector *s,
                                             struct message *list)
{
    while (list && !matching_selects(n, s, list))
        list = list->next;
    return list;
}

/* --- posted receives --- */

static inline void posted_begin(struct posted *p)
{
    p->first = NULL, p->end = &p->first;
}

static inline void posted_append(struct posted *p, struct receive *r)
{
    r->next = NULL;
    *p->end = r;
    p->end = &r->next;
}

static inline struct receive *posted_unlink(struct posted *p, struct receive **link)
{
    struct receive *r = *link;
    *link = r->next;
    if (p->end == &r->next)
        p->end = link;
    return r;
}

/* Removes r. False: it was not posted. */
static inline bool posted_remove(struct posted *p, const struct receive *r)
{
    for (struct receive **link = &p->first; *link; link = &(*link)->next)
        if (*link == r)
            return posted_unlink(p, link);
    return false;
}

/* Removes and returns the first that selects m; NULL: none does. */
static inline struct receive *posted_take(const struct node *n, struct posted *p, const struct message *m)
{
    for (struct receive **link = &p->first; *link; link = &(*link)->next)
        if (matching_selects(n, &(*link)->select, m))
            return posted_unlink(p, link);
    return NULL;
}

/* --- what a program gets --- */

/* Sets what infotype() and so on answer and, if not NULL, the program's array: type, length, node, process
 * type. */
static inline void matching_tell(struct node *n, const struct message *m, long array[])
{
    n->info = (struct node_info){(long)m->type, (long)m->bytes, nx_sender(n, m), (long)m->pid};
    const long told[] = {n->info.type, n->info.count, n->info.node, n->info.pid};
    for (size_t i = 0; array && i < sizeof told / sizeof *told; i++)
        node_put_long(n, array, i, told[i]);
}

static inline bool matching_fits(const struct receive *r)
{
    return r->m->bytes <= r->room;
}

/* The bytes and what is known of a complete message, to the program: mailbox_take. The message is still
 * r's. */
static inline long matching_take(struct node *n, const struct receive *r)
{
    const struct message *m = r->m;
    long result = 0;
    if (!matching_fits(r))
        result =
            node_error(n, EQMSGLONG, "the message of type %ld from %s has %zu bytes, but the buffer only %zu",
                       (long)m->type, nx_sender_name(n, m), m->bytes, r->room);
    else if (m->bytes && m->data != r->buf) /* else they have come there */
        memcpy(r->buf, m->data, m->bytes);
    if (!mailbox_is_library(m->type))
        matching_tell(n, m, r->info);
    return result;
}

#endif
