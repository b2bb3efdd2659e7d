/* mailbox_ids.h - the table of message ids in a mailbox. What others may do with ids is in mailbox.h. */
#ifndef CALLS_MAILBOX_IDS_H
#define CALLS_MAILBOX_IDS_H
#include "nx_api/calls/mailbox.h"

enum { IDS_BLOCK = 8 };

/* In two lines of the cache; what is looked at when a message comes lies in the first. */
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
};

struct mailbox_ids {
    struct id_block *first;
    uint32_t used;
    uint32_t ignored; /* of them: mailbox_settle looks after these */
};

/* The node's. */
struct mailbox_ids *mailbox_ids(const struct node *n);
/* first: room for the first block, for as long as there are ids. */
void ids_begin(struct mailbox_ids *ids, struct id_block *first);
void ids_end(struct mailbox_ids *ids);
#endif
