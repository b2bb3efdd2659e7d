/* node_record.h - what a node's program and system do, told to the recorder of the run's trace
 * (trace/recorder.h), if there is one. A call is told of when it ends, since it refers to what it sent,
 * took and waited for; until then it lies on a small stack: a call, a handler that interrupts it, a call
 * of the handler.
 *
 * A deferred call (deferred.h) lies in a ring of its own until it is committed: only then its times are
 * known. If its program is still in the call then, the call goes on as one that is not deferred. */
#ifndef OS_NODE_RECORD_H
#define OS_NODE_RECORD_H
#include "node/system.h"

/* Begins the record of a node that runs a program by its number; none if the trace leaves out the node. */
void record_begin(struct node *n, uint32_t program);
/* The node is gone, or the run is over: what is open ends at time t, unfinished unless the program has
 * ended. */
void record_end(struct node *n, vtime t);

/* A node that is recorded has been without a program up to time t, or since another has ended. */
void record_no_program(struct node *n, vtime t);

/* The rest for recorded nodes only: call these through the macro. */
#define RECORD(n, what, ...)                                                                                 \
    do {                                                                                                     \
        if (__builtin_expect((n)->record != NULL, 0))                                                        \
            record_##what((n), ##__VA_ARGS__);                                                               \
    } while (0)

/* The program has come to the call n->call; goes on. */
void record_call_begins(struct node *n);
void record_call_ends(struct node *n);
/* The call waits for a message to leave, or to come from a node (-1: from any). */
void record_awaits(struct node *n, bool sends, long from);
/* It has waited; so long of it the system was busy. */
void record_waited(struct node *n, vtime begin, vtime end, vtime busy);
/* It sends messages: the order of the first among the node's, and how many. */
void record_sends(struct node *n, uint64_t order, uint64_t count);
/* It, or the handler about to run, puts a message into the program's memory. */
void record_takes(struct node *n, const struct message *m);
/* The deferred call that has just begun: it is the one that the others above are about, while it is open. */
void record_deferred(struct node *n);
/* It is the call that the program was in already. */
void record_deferred_again(struct node *n);
/* The first deferred call is committed at time t; its caller resumes at time t, and is done at time
 * `done`; it is deferred no more. */
void record_committed(struct node *n, vtime t);
void record_resumed(struct node *n, vtime t, vtime done);
void record_popped(struct node *n);
/* All deferred calls are about to be undone, for good. */
void record_rolled_back(struct node *n);
void record_handler_begins(struct node *n, vtime due);
void record_handler_ends(struct node *n);
/* The system works until `end` because of a message. */
void record_system(struct node *n, enum node_task task, vtime end, vtime t);
#endif
