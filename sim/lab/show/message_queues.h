/* message_queues.h - the messages that are there for a node, and that it has not: on their way to it, or
 * complete and waiting until its program takes them. */
#ifndef LAB_SHOW_MESSAGE_QUEUES_H
#define LAB_SHOW_MESSAGE_QUEUES_H
#include "lab/draw/node_rows.h"
#include "lab/draw/time_bins.h"

enum queue_kind {
    QUEUE_WAITING, /* complete, not taken */
    QUEUE_COMING,  /* sent, not complete */
    QUEUE_KINDS
};

struct message_queues {
    int32_t rows;
    struct time_bins bins;
    bool bytes;   /* of messages, instead of their number */
    double *sums; /* messages (bytes) x picoseconds: [row][bin][kind] */
    struct {
        uint64_t length; /* messages, or bytes */
        int32_t node;    /* TRACE_NONE: no message waited */
        vtime time;      /* the first at which it was so long */
    } longest;           /* queue of messages that wait, at a node in the picture */
};

struct message_queues message_queues_make(const struct trace *t, const struct node_rows *r,
                                          struct time_bins bins, bool bytes);
void message_queues_free(struct message_queues *q);
/* The mean number of messages (bytes) in the bin: of a row, summed over its nodes. */
double message_queues_mean(const struct message_queues *q, int32_t row, uint32_t bin, enum queue_kind kind);
#endif
