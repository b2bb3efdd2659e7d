/* msgwait.h - what calls that give out message ids need. */
#ifndef CALLS_MSGWAIT_H
#define CALLS_MSGWAIT_H
#include "nx_api/calls/call.h"
#include "nx_api/contract/ids.h"

/* A message id; its use is ID_RECEIVES, ID_SENDS or both. -1 with the error: all are in use. */
long nx_new_id(struct node *n, unsigned use);
/* For node_wait: an id as a pointer. Have its parts all been sent and received? */
bool nx_id_is_complete(struct node *n, void *id);
/* Puts the messages of ignored ids that are complete into their buffers, and releases the ids. An error ends
 * the process: nobody asks for the id any more. */
void nx_settle(struct node *n);

#endif
