/* receive.h - what calls that receive or probe share. */
#ifndef CALLS_RECEIVE_H
#define CALLS_RECEIVE_H
#include "nx_api/calls/call.h"

struct incoming {
    struct selector select;
    void *buf;
    long len;
    long *info;
};

/* 0, or -1 with the error. */
long nx_check_receive(struct node *n, const struct incoming *in);
void nx_set_receive(struct receive *r, const struct incoming *in);
/* The receive of a blocking call. A handler, which may have interrupted such a call, has another. */
struct receive *nx_own_receive(struct node *n);
/* For node_wait. */
bool nx_receive_is_complete(struct node *n, void *receive);
/* Posts a receive, and a handler that runs when it is complete. */
long nx_post_handler(struct node *n, const struct incoming *in, mailbox_handler *handler, long param);

#endif
