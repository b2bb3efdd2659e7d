/* mailbox_ids.c - message ids: see mailbox.h. They begin at 1, as those of NX do: many programs have 0 for no message under
 * way. Ids that have been merged are linked by next, from the one that stands for
 * all:
 *
 *     id 3 -> id 7 -> id 2        3 is valid; 7 and 2 are parts
 *
 * The first free id is taken, and programs mostly have few: the table is a
 * list of blocks, all but the first made when they are wanted. What is in them stays where it is.
 */
#include "nx_api/calls/mailbox_ids.h"
#include <stdlib.h>
#include <string.h>
#include "nx_api/calls/backend.h"

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

void ids_begin(struct mailbox_ids *ids, struct id_block *first)
{
    memset(first, 0, sizeof *first);
    *ids = (struct mailbox_ids){first, 0, 0};
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
    drop(ids->first);
    for (struct id_block *b = ids->first->next, *next; b; b = next) {
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

long mailbox_id_new(struct node *n, unsigned use)
{
    struct mailbox_ids *ids = mailbox_ids(n);
    struct id_block **b = &ids->first;
    const long count = nx_message_ids(n);
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

static void settle(struct node *n, long id)
{
    for (long i = id; i >= 0; i = mailbox_id_next(n, i)) {
        struct receive *r = mailbox_id_receive(n, i);
        if (r && mailbox_take(n, r) < 0)
            node_fail(n, "msgignore: %s", n->error->text);
    }
    mailbox_id_release(n, id);
}

void mailbox_settle(struct node *n)
{
    struct mailbox_ids *ids = mailbox_ids(n);
    if (!ids->ignored)
        return;
    struct node_info before = n->info;
    long id = 1;
    for (const struct id_block *b = ids->first; ids->ignored && b; b = b->next)
        for (unsigned i = 0; i < IDS_BLOCK; i++, id++)
            if (b->ids[i].ignored && mailbox_id_is_complete(n, id)) {
                ids->ignored--;
                settle(n, id);
            }
    n->info = before;
}
