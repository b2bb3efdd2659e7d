/* numbering.h - the numbers by which schedules (doc/schedule-format.md) name what nodes do: messages,
 * receives, handlers, calls. There is a numbering only in runs that are recorded (schedule_record.h) or keep
 * orders (orders.h); then no call is deferred, so that all of it happens in the total order.
 *
 * An observer (os/observer.h) of each node counts. Counts belong to a node's number, and go on when another
 * program is loaded there. */
#ifndef REPLAY_NUMBERING_H
#define REPLAY_NUMBERING_H
#include "net/protocol_number.h"
#include "node/system.h"

/* A receive, from its posting until the program has its message. */
struct numbered_receive {
    struct numbered_receive *next, **link;
    uint64_t number;
    struct selector select;
    vtime posted;
    const char *call, *line;       /* that posted it; line NULL: not known */
    const struct plan_item *order; /* that it must keep; NULL: none */
    bool given;                    /* it has a message: the rest is known */
    uint32_t from;
    int32_t type;
    size_t bytes;
    struct message_number message;
};

struct numbered_node {
    uint64_t sends, receives, handlers, interrupts,
        calls;                      /* begun so far; of calls, those outside of handlers */
    uint32_t *sent_to;              /* by receiver; NULL: nothing yet */
    struct numbered_receive *first; /* in the order of posting */
    struct numbered_receive **end;
    bool *kept; /* by the plan's matches: a receive has had that message */
};

struct numbering {
    const struct plan *plan; /* with orders; NULL: none */
    FILE *out;               /* the record; NULL: none */
    /* The source line of the innermost of the program's functions on its stack, from a frame upwards; NULL:
     * not known. The text lasts as long as the machine. */
    const char *(*line)(void *ctx, const struct node *n, uintptr_t frame);
    void *line_ctx;
    uint32_t nodes;
    struct numbered_node node[]; /* and the host's */
};

/* For a machine of so many nodes, and a host. The caller sets line, before the run. */
struct numbering *numbering_new(uint32_t nodes, const struct plan *orders, FILE *out);
void numbering_free(struct numbering *b);
struct numbered_node *numbering_node(const struct node *n);
/* A node's number as schedules have it, of the program at an address. */
uint32_t numbering_index(const struct node_system *s, uint32_t address);

/* For a run that has a numbering: the node has been made; is about to be freed. */
void numbering_begin(struct node *n);
void numbering_end(struct node *n);
/* The run is over. */
void numbering_over(struct node *n);
#endif
