/* message_lengths.h - the distribution of messages' lengths: classes by powers of two. */
#ifndef LAB_SHOW_MESSAGE_LENGTHS_H
#define LAB_SHOW_MESSAGE_LENGTHS_H
#include "lab/show/message_matrix.h"

enum { LENGTH_CLASSES = 65 }; /* 0: no bytes; k: 2^(k-1) to 2^k - 1 bytes */

struct message_lengths {
    struct message_sum sums[LENGTH_CLASSES][2];          /* [1]: of messages that ask first, in three trips */
    uint64_t messages, bytes, shortest, longest, median; /* lengths in bytes; the median is the lower one */
    int first_class, last_class; /* with messages in them; first > last if there are no messages */
};

int length_class(uint64_t bytes);
/* Counts the messages sent from trace.from to trace.to. */
struct message_lengths message_lengths_make(const struct trace *t, const struct node_rows *r);
#endif
