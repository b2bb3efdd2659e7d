/* timeline.h - what happened on a node as nested slices, in order of time: the view that formats for other
 * tools have of a trace.
 *
 *     computing | csend          | computing | handler of type 7      | computing | crecv
 *                     waiting                  computing | csend                    waiting | system
 *
 * The slices that have none inside (computing, waiting, system) come from trace_pieces(). The rest of a call,
 * and no other slice, is the operating system's work for the call. So a node is idle for the sum of its
 * slices `waiting`, and in the system for that of `system`, and of the calls without what is inside of them.
 *
 * A slice never ends after the one around it, and never lies outside of what is in memory of the trace. */
#ifndef LAB_EXPORT_TIMELINE_H
#define LAB_EXPORT_TIMELINE_H
#include "lab/trace/trace_model.h"

/* What the walks of all nodes share: who sent and took which messages. Of a call, the first one; of a
 * message, the next one of the same call, in order of time; TRACE_NONE at the end. */
struct timeline {
    const struct trace *trace;
    int32_t *first_sent, *next_sent, *first_taken, *next_taken;
    int32_t *handler; /* of a message: that was run for it, if no call took the message; else TRACE_NONE */
};

enum timeline_kind {
    TIMELINE_COMPUTING,
    TIMELINE_WAITING,
    TIMELINE_SYSTEM,
    TIMELINE_CALL,
    TIMELINE_HANDLER,
    TIMELINE_LIBRARY /* a call of MPI that made several calls of the system; its index is one of these */
};

struct timeline_slice {
    enum timeline_kind kind;
    vtime begin, end;
    int32_t index; /* of a wait, system, call or handler in its table of the trace; TRACE_NONE: of none */
};

/* Of a message, on a walk: its two ends. */
struct timeline_end {
    int32_t message;
    int32_t call; /* that sent or took it; TRACE_NONE: a handler was run for it */
    vtime at;     /* within the slice of the call or handler */
    bool taken;   /* else sent */
};

/* What a walk calls, in order of time; between enter() and leave() of a slice for what is inside of it. */
struct timeline_visitor {
    void (*enter)(void *ctx, const struct timeline_slice *s);
    void (*leave)(void *ctx, const struct timeline_slice *s);
    void (*message)(void *ctx, const struct timeline_end *e);
};

/* t must outlive the result, of which timeline_free() frees the parts. */
struct timeline timeline_of(const struct trace *t);
void timeline_free(struct timeline *l);
/* visit's functions may be NULL. */
void timeline_walk(const struct timeline *l, int32_t node, const struct timeline_visitor *visit, void *ctx);

/* The node whose call sent the message; TRACE_NONE: a service. A message to all nodes goes from node to node:
 * it is `from` the last of these. */
int32_t timeline_sender(const struct timeline *l, int32_t message);
/* Does a walk come to both ends of the message? */
bool timeline_has_ends(const struct timeline *l, int32_t message);
/* "csend", "waiting", "system: receiving", "handler" ...: lives as long as the trace. */
const char *timeline_name(const struct trace *t, const struct timeline_slice *s);
/* The part of a time that is in memory. */
vtime timeline_within(const struct trace *t, vtime time);
#endif
