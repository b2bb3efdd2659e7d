/* ids.c - see ids.h. A new id is the first that is free, and most programs use few at a time: the table is a
 * list of blocks, which are made on demand. What is in a block stays where it is. */
#include "nx_api/contract/ids.h"
#include <stdlib.h>
#include <string.h>

/* NULL: there is no block for it. */
static struct id *at(const struct mailbox_ids *ids, long id)
{
    struct id_block *b = ids->first;
    long i = id - 1;
    for (; b && i >= IDS_BLOCK; i -= IDS_BLOCK)
        b = b->next;
    return b ? &b->ids[i] : NULL;
}

static struct id *of(const struct node *n, long id)
{
    return at(mailbox_ids(n), id);
}

static struct id_block *new_block(void)
{
    struct id_block *b = aligned_alloc(_Alignof(struct id_block), sizeof *b);
    if (!b)
        abort();
    return memset(b, 0, sizeof *b);
}

static void drop(struct id_block *b)
{
    for (unsigned i = 0; i < IDS_BLOCK; i++) {
        mailbox_drop(&b->ids[i].receive);
        free(b->ids[i].send);
    }
}

void ids_end(struct mailbox_ids *ids)
{
    for (struct id_block *b = ids->first, *next; b; b = next) {
        next = b->next;
        drop(b);
        free(b);
    }
}

static struct id *first_free(struct id_block *b)
{
    for (unsigned i = 0; i < IDS_BLOCK; i++)
        if (!b->ids[i].use)
            return &b->ids[i];
    return NULL;
}

long mailbox_id_new(struct node *n, unsigned use, uint32_t count)
{
    struct mailbox_ids *ids = mailbox_ids(n);
    struct id_block **b = &ids->first;
    for (long first = 0; first < count; first += IDS_BLOCK, b = &(*b)->next) {
        if (!*b)
            *b = new_block();
        struct id *id = first_free(*b);
        if (!id)
            continue;
        if (first + (id - (*b)->ids) >= count)
            break;
        id->use = (uint8_t)use, id->next = -1;
        ids->used++;
        if (use & ID_SENDS && !(id->send = calloc(1, sizeof *id->send)))
            abort();
        return first + (id - (*b)->ids) + 1;
    }
    return -1;
}

bool mailbox_id_is_valid(const struct node *n, long id)
{
    const struct id *i = id > 0 ? of(n, id) : NULL;
    return i && i->use && !i->part && !i->ignored;
}

long mailbox_id_next(const struct node *n, long id)
{
    return of(n, id)->next;
}

struct receive *mailbox_id_receive(struct node *n, long id)
{
    struct id *i = of(n, id);
    return i->use & ID_RECEIVES ? &i->receive : NULL;
}

struct send *mailbox_id_send(struct node *n, long id)
{
    return of(n, id)->send;
}

bool mailbox_id_is_complete(struct node *n, long id)
{
    while (id >= 0) {
        const struct id *i = of(n, id);
        if ((i->use & ID_RECEIVES && !mailbox_complete(n, &i->receive)) || (i->send && !i->send->done))
            return false;
        id = i->next;
    }
    return true;
}

void mailbox_id_release(struct node *n, long id)
{
    while (id >= 0) {
        struct id *i = of(n, id);
        id = i->next;
        if (i->send)
            mailbox_unfollow(i->send);
        free(i->send);
        i->send = NULL, i->receive.m = NULL;
        i->use = 0, i->part = i->ignored = false;
        mailbox_ids(n)->used--;
    }
}

void mailbox_id_merge(struct node *n, long id, long part)
{
    while (of(n, id)->next >= 0)
        id = of(n, id)->next;
    of(n, id)->next = part;
    of(n, part)->part = true;
}

void mailbox_id_ignore(struct node *n, long id)
{
    of(n, id)->ignored = true;
    mailbox_ids(n)->ignored++;
}

long mailbox_id_take_ignored(struct node *n, long id)
{
    struct mailbox_ids *ids = mailbox_ids(n);
    for (struct id *i; ids->ignored && (i = of(n, ++id));)
        if (i->ignored && mailbox_id_is_complete(n, id)) {
            ids->ignored--;
            return id;
        }
    return -1;
}
