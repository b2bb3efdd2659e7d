/* send.h - what calls that send share. */
#ifndef CALLS_SEND_H
#define CALLS_SEND_H
#include "nx_api/calls/call.h"

/* 0, or -1 with the error. */
long nx_check_send(struct node *n, const struct outgoing *o);
/* The new send of a blocking call. A handler, which may have interrupted such a call, has another. */
struct send *nx_own_send(struct node *n);
/* For node_wait. */
bool nx_send_is_done(struct node *n, void *send);

#endif
