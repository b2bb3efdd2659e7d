/* mailbox_ids.c - message ids: see mailbox.h. Ids that have been merged are linked by next, from the one that stands for
 * all:
 *
 *     id 3 -> id 7 -> id 2        3 is valid; 7 and 2 are parts
 */
#include "nx_api/calls/mailbox_ids.h"
#include <stdlib.h>

struct id {
    unsigned use; /* ID_RECEIVES, ID_SENDS; 0: free */
    bool part, ignored;
    struct receive receive;
    struct send *send; /* malloc'd */
    long next;         /* part, -1: none */
};

void ids_free(struct mailbox_ids *ids)
{
    for (uint32_t i = 0; ids->table && i < ids->count; i++) {
        mailbox_drop(&ids->table[i].receive);
        free(ids->table[i].send);
    }
    free(ids->table);
}

long mailbox_id_new(struct node *n, unsigned use)
{
    struct mailbox_ids *ids = mailbox_ids(n);
    if (!ids->table && !(ids->table = calloc(ids->count, sizeof *ids->table)))
        abort();
    for (uint32_t i = 0; i < ids->count; i++) {
        struct id *id = &ids->table[i];
        if (id->use)
            continue;
        *id = (struct id){.use = use, .next = -1};
        if (use & ID_SENDS && !(id->send = calloc(1, sizeof *id->send)))
            abort();
        return i;
    }
    return -1;
}

bool mailbox_id_is_valid(const struct node *n, long id)
{
    const struct mailbox_ids *ids = mailbox_ids(n);
    if (id < 0 || id >= ids->count || !ids->table)
        return false;
    const struct id *i = &ids->table[id];
    return i->use && !i->part && !i->ignored;
}

long mailbox_id_next(const struct node *n, long id)
{
    return mailbox_ids(n)->table[id].next;
}

struct receive *mailbox_id_receive(struct node *n, long id)
{
    struct id *i = &mailbox_ids(n)->table[id];
    return i->use & ID_RECEIVES ? &i->receive : NULL;
}

struct send *mailbox_id_send(struct node *n, long id)
{
    return mailbox_ids(n)->table[id].send;
}

bool mailbox_id_is_complete(struct node *n, long id)
{
    for (; id >= 0; id = mailbox_id_next(n, id)) {
        const struct receive *r = mailbox_id_receive(n, id);
        const struct send *s = mailbox_id_send(n, id);
        if ((r && !mailbox_complete(n, r)) || (s && !s->done))
            return false;
    }
    return true;
}

void mailbox_id_release(struct node *n, long id)
{
    while (id >= 0) {
        struct id *i = &mailbox_ids(n)->table[id];
        id = i->next;
        if (i->send)
            mailbox_unfollow(i->send);
        free(i->send);
        *i = (struct id){0};
    }
}

void mailbox_id_merge(struct node *n, long id, long part)
{
    struct id *table = mailbox_ids(n)->table;
    while (table[id].next >= 0)
        id = table[id].next;
    table[id].next = part;
    table[part].part = true;
}

void mailbox_id_ignore(struct node *n, long id)
{
    mailbox_ids(n)->table[id].ignored = true;
    mailbox_ids(n)->ignored++;
}

static void settle(struct node *n, long id)
{
    for (long i = id; i >= 0; i = mailbox_id_next(n, i)) {
        struct receive *r = mailbox_id_receive(n, i);
        if (r && mailbox_take(n, r) < 0)
            node_fail(n, "msgignore: %s", n->error.text);
    }
    mailbox_id_release(n, id);
}

void mailbox_settle(struct node *n)
{
    struct mailbox_ids *ids = mailbox_ids(n);
    if (!ids->ignored)
        return;
    struct node_info before = n->info;
    for (uint32_t i = 0; ids->ignored && i < ids->count; i++)
        if (ids->table[i].ignored && mailbox_id_is_complete(n, i)) {
            ids->ignored--;
            settle(n, i);
        }
    n->info = before;
}
