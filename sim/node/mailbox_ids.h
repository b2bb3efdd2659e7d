/* mailbox_ids.h - the table of message ids in a mailbox. What others may do with ids is in mailbox.h. */
#ifndef NODE_MAILBOX_IDS_H
#define NODE_MAILBOX_IDS_H
#include "node/mailbox.h"

struct mailbox_ids {
    struct id *table; /* made when the first is wanted */
    uint32_t count;
    uint32_t ignored; /* ids that mailbox_settle looks after */
};

/* The node's: mailbox.c. */
struct mailbox_ids *mailbox_ids(const struct node *n);
void ids_free(struct mailbox_ids *ids);
#endif
