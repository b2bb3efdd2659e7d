/* why.h - the analysis of why a run took its time: all that is found in a trace, and sums of it.
 *
 *     path    the critical path (critical_path.h), and what has which share in it
 *     causes  the waits of all nodes, by cause (wait_causes.h), and in groups of waits that are alike */
#ifndef LAB_WHY_H
#define LAB_WHY_H
#include "lab/why/critical_path.h"
#include "lab/trace/program_places.h"
#include "lab/why/tally.h"
#include "lab/why/wait_causes.h"

/* What the path's time is divided by. */
enum why_share {
    WHY_BY_NODE,     /* "node 0"; "network" */
    WHY_BY_FUNCTION, /* of the program: where it came to, or the handler's; "" of the path's other time */
    WHY_BY_CALL,     /* "csend at ring.c:12 (main)" */
    WHY_BY_MESSAGE,  /* "type 2": calls that send or take messages, and the messages' way */
    WHY_SHARES
};

/* Waits of one cause, in one call of the program, for messages of one call of the program. */
struct wait_group {
    enum wait_cause cause;
    enum trace_state doing; /* late sender, late receiver: what the partner did */
    const char *call;       /* in which nodes waited: "crecv at ring.c:15 (main)" */
    const char *sent;       /* the partner's call: "csend at ring.c:12 (main)"; "" */
    bool leaves;            /* they waited until messages had left */
    bool has_type;          /* of the messages: from type to last_type */
    int32_t type, last_type;
    int32_t pid;     /* of all of them; 0: of NX, or several */
    int32_t partner; /* into trace.nodes; TRACE_NONE: nobody, or a service */
    bool partners;   /* there are others, too */
    vtime_sum idle;
    vtime longest_idle;
    int32_t longest; /* the longest wait */
    int32_t block;   /* WAIT_CHANNEL: the longest; else TRACE_NONE */
    vtime longest_block;
    uint64_t waits;
    int32_t nodes;     /* so many different ones waited */
    int32_t last_node; /* the last of them */
};

struct why {
    struct trace *t;
    struct piece_map map;
    struct wait_enders enders;
    struct places *places;
    struct path path;
    struct wait_causes causes;
    bool some_nodes; /* not all nodes' waits are in causes */
    vtime length;    /* of the path: the trace's time */
    vtime_sum by_class[WHY_CLASSES];
    vtime entering; /* of WHY_HANDLERS: the system enters handlers, and leaves them */
    struct tally shares[WHY_SHARES];
    struct wait_group *groups; /* the longest first */
    size_t group_count;
    int32_t *holder; /* by block: the message that held the channel at the block's end; TRACE_NONE */
};

/* Takes over the trace. only: whose waits count; NULL: all nodes'. */
struct why *why_new(struct trace *t, const struct trace_selection *only);
void why_free(struct why *w);

/* "node 3"; "network" for TRACE_NONE. */
const char *why_node_name(const struct why *w, int32_t node);
#endif
