/* wait_causes.h - the causes of nodes' waits: the idle time of all waits, divided by cause.
 *
 * A wait is divided along the way of the message that ended it (message_way.h). While the message was on
 * that way, the leg is the cause; before it was sent, what its sender did. Only time counts in which the
 * waiting processor was idle. So the amounts are exact, and their sum is the nodes' idle time, as
 * touchstone run --json gives it. */
#ifndef LAB_WHY_WAIT_CAUSES_H
#define LAB_WHY_WAIT_CAUSES_H
#include "lab/why/message_way.h"

enum wait_cause {
    WAIT_LATE_SENDER,    /* the message was not sent yet: its sender computed, called or waited itself */
    WAIT_LATE_RECEIVER,  /* a long message waited until its receiver had a receive for it, or room */
    WAIT_HANDLER,        /* the partner was in a handler */
    WAIT_OTHER_MESSAGES, /* the partner's processor, or the waiting one's, handled other messages */
    WAIT_CHANNEL,        /* another message held a channel of the path */
    WAIT_NETWORK,        /* the message, its request or its clear to send was on its way */
    WAIT_MESSAGE,        /* the partner's system worked for the message itself */
    WAIT_DISK,           /* the call waited for the file system */
    WAIT_NEVER,          /* nothing ended the wait: it lasted to the end of the run, or of the trace */
    WAIT_UNKNOWN, /* the call waited for a service (load, getcube), or the trace does not say for what */
    WAIT_CAUSES
};

/* A part of a wait's idle time. */
struct wait_part {
    enum wait_cause cause;
    enum trace_state doing; /* late sender, late receiver: what the partner did */
    int32_t wait;           /* into trace.waits */
    int32_t node;           /* which waited */
    int32_t partner;        /* into trace.nodes; TRACE_NONE: nobody, or a service */
    int32_t message;        /* that ended the wait; TRACE_NONE: not known */
    int32_t block;          /* WAIT_CHANNEL: the longest of the parts; else TRACE_NONE */
    vtime idle;
};

struct wait_causes {
    struct wait_part *parts; /* by node, then in the order of time */
    size_t count;
    vtime_sum idle; /* of all nodes; the sum of all parts */
    vtime_sum by_cause[WAIT_CAUSES];
};

/* Divides the waits of the traced nodes; only: of those selected; NULL: of all. free(causes.parts) in the
 * end. */
struct wait_causes wait_causes_find(const struct trace *t, struct piece_map *map, const struct wait_enders *e,
                                    const struct trace_selection *only);

/* "late sender", "channel busy" ...; and as a key of JSON: "late_sender". */
const char *wait_cause_name(enum wait_cause c);
const char *wait_cause_key(enum wait_cause c);
#endif
