/* message_sample.h - the sample of messages for a picture that has no room for all. */
#ifndef LAB_SHOW_MESSAGE_SAMPLE_H
#define LAB_SHOW_MESSAGE_SAMPLE_H
#include "lab/draw/node_rows.h"

struct message_sample {
    int32_t *list; /* indexes into trace.messages, ascending */
    size_t count, of;
};

/* `most` of the messages between two nodes in the picture that are under way between trace.from and
 * trace.to; all of them, if they are not more. One of each run of of/count messages, chosen by a fixed
 * hash: the same ones each time, in no step with the program's own pattern. */
struct message_sample message_sample_make(const struct trace *t, const struct node_rows *r, size_t most);
void message_sample_free(struct message_sample *s);
#endif
