/* awaited.h - what a call waits for, for reports: from what the call has given to node_wait(). */
#ifndef CALLS_AWAITED_H
#define CALLS_AWAITED_H
#include "nx_api/calls/call.h"

/* One thing that is not there yet; of several (merged ids), the first. All NULL and false: something else,
 * such as a file, or nothing any more. */
struct awaited {
    const struct receive *receive; /* its message */
    const struct selector *probe;  /* a message that cprobe would find */
    const struct send *send;       /* its buffer may not be used again */
    bool end, all;                 /* of the process on node `of`; ALL_NODES: of any, or of all others */
    long of;
};

/* Changes nothing. */
struct awaited nx_awaited(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg);
#endif
