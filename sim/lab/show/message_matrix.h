/* message_matrix.h - the messages and bytes that each row of nodes sent to each. */
#ifndef LAB_SHOW_MESSAGE_MATRIX_H
#define LAB_SHOW_MESSAGE_MATRIX_H
#include "lab/draw/node_rows.h"

struct message_matrix {
    int32_t size; /* rows; one more than the nodes have if `others` */
    bool others;  /* the last row: I/O nodes, and nodes that are not in the picture */
    uint64_t messages, bytes;
    struct message_sum {
        uint64_t messages, bytes;
    } * cells; /* [from][to] */
};

/* Counts the messages sent from trace.from to trace.to. Freed by message_matrix_free(). */
struct message_matrix message_matrix_make(const struct trace *t, const struct node_rows *r);
void message_matrix_free(struct message_matrix *m);
static inline struct message_sum *message_matrix_at(const struct message_matrix *m, int32_t from, int32_t to)
{
    return &m->cells[(size_t)from * (size_t)m->size + (size_t)to];
}
/* Was the message sent in the time that is in memory, and is an end of it a node in the picture? */
bool message_counts(const struct trace *t, const struct node_rows *r, const struct trace_message *m);
#endif
