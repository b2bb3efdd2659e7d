/* mailbox_ids.h - the table of message ids in a mailbox. What others may do with ids is in mailbox.h. */
#ifndef CALLS_MAILBOX_IDS_H
#define CALLS_MAILBOX_IDS_H
#include <stdint.h>

struct node;

struct mailbox_ids {
    struct id_block *first; /* NULL: none has been wanted yet */
    uint32_t count;         /* of ids that there may be */
    uint32_t ignored;       /* ids that mailbox_settle looks after */
};

/* The node's. */
struct mailbox_ids *mailbox_ids(const struct node *n);
void ids_free(struct mailbox_ids *ids);
#endif
