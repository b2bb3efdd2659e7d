/* critical_path.h - the critical path of a run: what its time was needed for, from its end back to its
 * start.
 *
 * The path begins at the node that ended last, and goes back in that node's time: computing, calls,
 * handlers, the system. Where the node waited, the path jumps from the end of the wait, along the message
 * that ended it (message_way.h), to the call that sent the message, and goes on there. Two more rules:
 *  - A long message whose receiver let it wait leads to the receiver, at the moment of the clear to send:
 *    not the sender was late.
 *  - A message that a handler sent leads through the handler to the moment at which the handler was due,
 *    and from there along the message that made it due. A handler that only delayed the program leads to
 *    the program.
 *
 * Of nodes that are not in the trace nothing is known: the path stays on those that are, and has such waits
 * as WHY_WAITING.
 *
 * The steps fill the trace's time, from trace.from to trace.to, without gap or overlap. */
#ifndef LAB_WHY_CRITICAL_PATH_H
#define LAB_WHY_CRITICAL_PATH_H
#include "lab/why/message_way.h"

/* Indexes into the tables of the trace; TRACE_NONE: none. */
struct path_step {
    vtime begin, end;
    enum why_class class;
    int32_t node;        /* whose processor it is about; TRACE_NONE: the network */
    int32_t call;        /* in which the node was, or for which it waited */
    int32_t handler;     /* in which the node was */
    int32_t message;     /* whose way it is */
    bool enters_handler; /* WHY_HANDLERS: the system enters the handler, or leaves it */
    int32_t block;       /* WHY_CHANNEL */
    int32_t stack;       /* where the program was at the step's end; computing: where it came to */
    int32_t before;      /* computing: where the program was before: its call, or TRACE_NONE: it begins */
    int32_t seen;        /* computing: where a handler interrupted it; TRACE_NONE: none did */
};

struct path {
    struct path_step *steps; /* in the order of time */
    size_t count;
    size_t jumps; /* from one node to another */
};

/* Finds the path. free(path.steps) in the end. */
struct path path_find(const struct trace *t, struct piece_map *map, const struct wait_enders *enders);
#endif
