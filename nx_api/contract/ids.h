/* ids.h - a node's message ids, 1 or more: what isend, irecv and isendrecv give out. 0 is none: many programs
 * have it for no message under way.
 *
 * An id stands for a receive, a send, or both. Ids that have been merged are linked by next, and the first
 * stands for all:
 *
 *     id 3 -> id 7 -> id 2        3 is valid; 7 and 2 are parts
 */
#ifndef CONTRACT_IDS_H
#define CONTRACT_IDS_H
#include "nx_api/contract/message.h"

enum { IDS_BLOCK = 8 };
enum { ID_RECEIVES = 1, ID_SENDS = 2 };

/* In two lines of the cache; what the arrival of a message reads lies in the first. */
struct id {
    _Alignas(128) struct receive receive;
    struct send *send; /* malloc'd */
    long next;         /* part, -1: none */
    uint8_t use; /* ID_RECEIVES, ID_SENDS; 0: free, and then it has no send, no message and neither flag */
    bool part, ignored;
};

struct id_block {
    struct id ids[IDS_BLOCK];
    struct id_block *next;
    /* of the first block: */
    struct id_block **more; /* those behind it, by number */
    uint32_t count;         /* of them */
    uint32_t full;          /* so many blocks, from the first on, have no free id */
};

/* All 0: no id has been given out. */
struct mailbox_ids {
    struct id_block *first;
    uint32_t used;
    uint32_t ignored; /* of them */
};

/* The node's table, which its back end keeps. */
struct mailbox_ids *mailbox_ids(const struct node *n);
/* Frees all, and what their receives and sends have. */
void ids_end(struct mailbox_ids *ids);

/* A new id, of at most `count` at a time; -1: all are taken. */
long mailbox_id_new(struct node *n, unsigned use, uint32_t count);
bool mailbox_id_is_valid(const struct node *n, long id);     /* in use, and neither a part nor ignored */
long mailbox_id_next(const struct node *n, long id);         /* the next of its parts, -1: no more */
struct receive *mailbox_id_receive(struct node *n, long id); /* NULL: it has none */
struct send *mailbox_id_send(struct node *n, long id);
bool mailbox_id_is_complete(struct node *n, long id); /* with all its parts */
void mailbox_id_release(struct node *n, long id);     /* and its parts */
void mailbox_id_merge(struct node *n, long id, long part);
/* The program will not ask for the id again. */
void mailbox_id_ignore(struct node *n, long id);
/* The first ignored id behind `id` that is complete. It is ignored no longer, and the caller is to release
 * it. -1: none. */
long mailbox_id_take_ignored(struct node *n, long id);
#endif
