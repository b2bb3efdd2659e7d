/* mpi_mailbox.h - the messages of a node on MPI. What calls do with them: contract/message.h; which message a
 * receive takes: contract/matching.h. A message may be selected before its bytes have come. */
#ifndef MPI_MAILBOX_H
#define MPI_MAILBOX_H
#include "backend_node.h"

struct mpi_mailbox *mpi_mailbox_new(void);
/* Gives a message, which the mailbox is to free, to the receive that selects it. If none does the message is
 * unexpected; a forced one is thrown away. */
void mpi_mailbox_deliver(struct node *n, struct message *m);
/* The bytes of a message have come. */
void mpi_mailbox_whole(struct node *n, struct message *m);
/* Where the bytes of a message, which come now, may be received: the buffer of its receive. NULL: it has
 * none, or one that is too small. */
void *mpi_mailbox_place(const struct message *m);
void mpi_mailbox_flush(struct node *n, int64_t typesel);
/* Runs the first handler that is due; false if none is, or may run now. */
bool mpi_mailbox_run_handler(struct node *n);

/* For reports: lists, linked by next; and the receive of the i-th handler that is due, NULL if it is of a
 * send. False: there are not so many. */
const struct message *mpi_mailbox_unexpected(const struct node *n);
const struct receive *mpi_mailbox_posted(const struct node *n);
bool mpi_mailbox_due(const struct node *n, unsigned i, const struct receive **r);
#endif
