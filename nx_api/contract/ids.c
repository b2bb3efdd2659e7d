/* ids.c - see ids.h. A new id is the first that is free, and most programs use few at a time: they are in
 * blocks, which are made on demand. What is in a block stays where it is. */
#include "nx_api/contract/ids.h"
#include <stdlib.h>
#include <string.h>

/* NULL: there is none. */
static struct id_block *block_of(const struct mailbox_ids *ids, unsigned long i)
{
    struct id_block *first = ids->first;
    return i == 0 || !first ? first : i <= first->count ? first->more[i - 1] : NULL;
}

/* NULL: there is no block for it. */
static struct id *at(const struct mailbox_ids *ids, long id)
{
    unsigned long i = (unsigned long)id - 1;
    struct id_block *b = i < IDS_BLOCK ? ids->first : block_of(ids, i / IDS_BLOCK);
    return b ? &b->ids[i % IDS_BLOCK] : NULL;
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

/* Makes the next block. The list of those behind the first grows when it has a power of 2. */
static struct id_block *add_block(struct mailbox_ids *ids)
{
    struct id_block *first = ids->first;
    if (!first)
        return ids->first = new_block();
    uint32_t n = first->count;
    if (!(n & (n - 1)) && !(first->more = realloc(first->more, (2 * (size_t)n + 1) * sizeof *first->more)))
        abort();
    block_of(ids, n)->next = first->more[n] = new_block();
    first->count++;
    return first->more[n];
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
    if (ids->first)
        free(ids->first->more);
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
    for (uint32_t i = ids->first ? ids->first->full : 0;; i++) {
        long first = (long)i * IDS_BLOCK;
        if (first >= count)
            return -1;
        struct id_block *b = block_of(ids, i);
        struct id *id = first_free(b ? b : (b = add_block(ids)));
        if (!id) {
            ids->first->full = i + 1;
            continue;
        }
        if (first + (id - b->ids) >= count)
            return -1;
        id->use = (uint8_t)use, id->next = -1;
        ids->used++;
        if (use & ID_SENDS && !(id->send = calloc(1, sizeof *id->send)))
            abort();
        return first + (id - b->ids) + 1;
    }
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
    struct mailbox_ids *ids = mailbox_ids(n);
    while (id >= 0) {
        struct id *i = at(ids, id);
        if (ids->first->full > (uint32_t)(id - 1) / IDS_BLOCK)
            ids->first->full = (uint32_t)(id - 1) / IDS_BLOCK;
        id = i->next;
        if (i->send)
            mailbox_unfollow(i->send);
        free(i->send);
        i->send = NULL, i->receive.m = NULL;
        i->use = 0, i->part = i->ignored = false;
        ids->used--;
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
