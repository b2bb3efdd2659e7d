/* numbering.h - the numbers by which schedules (doc/schedule-format.md) name what nodes do: messages,
 * receives, handlers, calls. There is a numbering only in runs that are recorded (schedule_record.h) or keep
 * orders (orders.h); then no call is deferred, so that all of it happens in the total order.
 *
 * Counts belong to a node's number, and go on when another program is loaded there. */
#ifndef OS_NUMBERING_H
#define OS_NUMBERING_H
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

/* The rest for runs that have a numbering only: call these through the macro. */
#define NUMBER(n, what, ...)                                                                                 \
    do {                                                                                                     \
        if (__builtin_expect((n)->sys->numbering != NULL, 0))                                                \
            number_##what((n), ##__VA_ARGS__);                                                               \
    } while (0)

/* The program begins a call. */
void number_call(struct node *n);
/* It has sent messages, linked by next, at time t, which leave so much later. */
void number_send(struct node *n, const struct message *first, vtime t, vtime late);
/* The envelope of m comes to n. */
void number_came(struct node *n, const struct message *m, vtime now);
/* r is going to be posted; has been given a message; has been withdrawn; the program has its message. */
void number_post(struct node *n, struct receive *r, vtime now);
void number_give(struct node *n, const struct receive *r, const struct message *m);
void number_withdraw(struct node *n, struct receive *r);
void number_take(struct node *n, struct receive *r);
/* A handler becomes due at a time, so much later than usual. A handler that was due at a time runs, for r or
 * a send. */
void number_due(struct node *n, vtime due, vtime late);
void number_handler(struct node *n, vtime due, const struct receive *r);
/* The node's program is gone, or the run over. */
void number_end(struct node *n);
#endif
