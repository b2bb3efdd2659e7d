/* recording.h - a schedule file (doc/schedule-format.md) in memory: what touchstone run --record wrote.
 *
 *     delays      in what the run differed from the machine's usual timing
 *     messages    one a message that a receive got, or that lay unreceived at the end; sorted by sender,
 *                 receiver and number
 *     receives    one a receive that got its message; sorted by node, then in the order of posting
 *     handlers    one a handler that ran; sorted by node, then in the order of running
 *
 * Nodes are numbers; the host has the number `nodes`. Times are virtual, in picoseconds; VT_NEVER where the
 * file does not tell. */
#ifndef LAB_EXPLORE_RECORDING_H
#define LAB_EXPLORE_RECORDING_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include "kernel/vtime.h"
#include "lab/explore/delays.h"

struct rec_message {
    uint32_t from, to;
    uint64_t number; /* of all messages that `from` sent to `to` */
    uint64_t index;  /* of all messages that `from` sent, for DELAY_MESSAGE; REC_UNKNOWN */
    int64_t type;
    vtime sent, came; /* the program sent it; a receive could take it. came VT_NEVER: it was under way */
    int64_t bytes;
    int64_t taken; /* by which of recording.receives; REC_NONE: by none */
    char *line;    /* where it was sent; NULL: not known */
};

struct rec_receive {
    uint32_t node;
    uint64_t number; /* of the node's receives */
    uint32_t from;
    uint64_t from_number; /* the message: rec_message.number */
    int64_t message;      /* into recording.messages */
    int64_t typesel;
    int64_t selected; /* the node that the message must be from; REC_ANY: any node */
    vtime posted, at; /* the program called it; had the message */
    char *call, *line;
};

struct rec_handler {
    uint32_t node;
    uint64_t number;
    uint64_t calls;  /* that the node's program had begun */
    int64_t receive; /* the number of the node's receive whose message it runs for; REC_NONE: for none */
    vtime due, at;
    char *line; /* where the program was interrupted */
};

enum { REC_NONE = -1, REC_ANY = -1 };
#define REC_UNKNOWN UINT64_MAX

struct recording {
    uint32_t nodes;
    struct delays delays;
    struct rec_message *messages;
    struct rec_receive *receives;
    struct rec_handler *handlers;
    size_t message_count, receive_count, handler_count;
};

/* Reads a file. NULL with *error malloc'd, which names file and line. */
struct recording *recording_load(const char *path, char **error);
/* Reads the text of a file of that name. */
struct recording *recording_read(FILE *in, const char *path, char **error);
void recording_free(struct recording *r);

/* How many programs there were: one on each node; with a host, its own and those that exchanged messages. */
uint32_t recording_programs(const struct recording *r);

/* The number-th receive of a node; NULL: it got no message. */
const struct rec_receive *recording_receive(const struct recording *r, uint32_t node, uint64_t number);
/* The number-th handler of a node; NULL: it did not run. */
const struct rec_handler *recording_handler(const struct recording *r, uint32_t node, uint64_t number);
#endif
