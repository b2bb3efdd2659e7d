/* process_calls.h - what waitall and waitone wait for. */
#ifndef CALLS_PROCESS_CALLS_H
#define CALLS_PROCESS_CALLS_H
#include "nx_api/calls/call.h"

/* For node_wait, with a node's number, a word, or ALL_NODES. */
bool nx_all_have_ended(struct node *n, void *node);
bool nx_one_has_ended(struct node *n, void *node);
#endif
