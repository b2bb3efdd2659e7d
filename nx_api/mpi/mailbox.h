/* mailbox.h - the messages of a node on MPI: those that have come whole. What the calls do with them: calls/mailbox.h.
 *
 *   a message comes:    a posted receive selects it  ->  it is that receive's; if it has a handler, that is due
 *                       none does                    ->  it waits, unexpected; a forced one is dropped
 *   a receive is made:  the first unexpected message it selects, else it is posted (first posted, first served)
 */
#ifndef MPI_MAILBOX_H
#define MPI_MAILBOX_H
#include "nx_api/mpi/node.h"

struct message {
    struct message *next;
    long type, pid;
    uint32_t source;
    size_t bytes;
    const char *data; /* inside block */
    void *block;      /* malloc'd: freed with the message */
};

struct mailbox *mailbox_new(void);
/* Gives the message to the node; it is the mailbox's from then on. */
void mailbox_deliver(struct node *n, struct message *m);
void mailbox_flush(struct node *n, int64_t typesel);
/* Runs the first handler that is due; false if none is, or may run now. */
bool mailbox_run_handler(struct node *n);
#endif
