/* mailbox_ids.c - message ids: see mailbox.h. Ids that have been merged are linked by next, from the one that stands for
 * all:
 *
 *     id 3 -> id 7 -> id 2        3 is valid; 7 and 2 are parts
 *
 * The first free id is taken, and programs mostly have few: the table is made in blocks. What is in them stays where it is.
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

enum { BLOCK = 8 };

static struct id *at(const struct mailbox_ids *ids, long id)
{
    return &ids->blocks[id / BLOCK][id % BLOCK];
}

static struct id *of(const struct node *n, long id)
{
    return at(mailbox_ids(n), id);
}

/* Those that there is a block for. */
static uint32_t made(const struct mailbox_ids *ids)
{
    uint32_t blocks = 0;
    while (ids->blocks && ids->blocks[blocks])
        blocks++;
    return blocks * BLOCK < ids->count ? blocks * BLOCK : ids->count;
}

static void add_block(struct mailbox_ids *ids)
{
    uint32_t blocks = made(ids) / BLOCK;
    ids->blocks = realloc(ids->blocks, (blocks + 2) * sizeof *ids->blocks);
    if (!ids->blocks || !(ids->blocks[blocks] = calloc(BLOCK, sizeof **ids->blocks)))
        abort();
    ids->blocks[blocks + 1] = NULL;
}

void ids_free(struct mailbox_ids *ids)
{
    for (uint32_t i = 0, count = made(ids); i < count; i++) {
        mailbox_drop(&at(ids, i)->receive);
        free(at(ids, i)->send);
    }
    for (struct id **block = ids->blocks; block && *block; block++)
        free(*block);
    free(ids->blocks);
}

long mailbox_id_new(struct node *n, unsigned use)
{
    struct mailbox_ids *ids = mailbox_ids(n);
    for (uint32_t i = 0, count = made(ids); i < ids->count; i++) {
        if (i == count) {
            add_block(ids);
            count = made(ids);
        }
        struct id *id = at(ids, i);
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
    if (id < 0 || id >= made(mailbox_ids(n)))
        return false;
    const struct id *i = of(n, id);
    return i->use && !i->part && !i->ignored;
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
        *i = (struct id){0};
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
    for (uint32_t i = 0, count = made(ids); ids->ignored && i < count; i++)
        if (at(ids, i)->ignored && mailbox_id_is_complete(n, i)) {
            ids->ignored--;
            settle(n, i);
        }
    n->info = before;
}
