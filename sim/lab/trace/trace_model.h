/* trace_model.h - a trace in memory: what a run of touchstone run --trace noted, as tables.
 *
 * A trace file (doc/trace-format.md) is a stream in the order in which things became known. trace_load()
 * reads it into tables that are sorted and refer to each other by index. All times are virtual, in
 * picoseconds.
 *
 *     nodes                 one an address that runs a program; the host, if there is one, is the last
 *       calls               one a call of NX: in order of their beginnings
 *         waits             one an interval in which the program waited in the call
 *       handlers            one a run of a handler of hrecv, hsend ...
 *       systems             one an interval in which the operating system had the processor because of a
 *                           message, while the program computed or waited
 *     messages              one a message, in the order of sending
 *       blocks              one an interval in which the message waited for a channel that another held
 *
 * What a program did not do in calls, handlers or system it computed: trace_pieces() divides a node's
 * time. */
#ifndef LAB_TRACE_MODEL_H
#define LAB_TRACE_MODEL_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "kernel/vtime.h"
#include "net/topo.h"

/* An index that refers to nothing. */
enum { TRACE_NONE = -1 };

/* What the operating system did: enum node_task (node/node.h) of the simulator, as far as traces have it. */
enum trace_task { TRACE_SENDING, TRACE_RECEIVING, TRACE_FEEDING, TRACE_EMPTYING };

/* What kind of call it is, by its name. */
enum trace_class { TRACE_SENDS, TRACE_RECEIVES, TRACE_GLOBAL, TRACE_FILES, TRACE_OTHER };

struct trace_call {
    vtime begin, end; /* the program came to the call; went on */
    /* what the system did for messages up to then is part of the call; later it delays the program */
    vtime ordered;
    int32_t node;  /* index into trace.nodes */
    int32_t name;  /* index into trace.names: "csend" */
    int32_t stack; /* of the program, at the call: trace_stack(); TRACE_NONE: not known */
    int32_t type;  /* the type, typesel or id that the call was given, if has_type */
    bool has_type;
    bool unfinished; /* the run, or the trace, ended in the call */
    bool in_handler;
    bool continues; /* a part of the same call of MPI as the node's call before */
    /* Messages, indexes into trace.messages: the first that the call sent (of a message to all nodes there
     * are more, with the same call as their `sending`), and the last that the call put into the program's
     * memory. */
    int32_t sent, taken;
    int32_t first_wait, waits; /* into trace.waits */
};

struct trace_wait {
    vtime begin, end;
    vtime idle; /* of end - begin: the processor was idle; the rest is the system's */
    int32_t node, call;
    int32_t type; /* type or typesel of the message waited for, if has_type */
    bool has_type;
    bool sends;   /* the call waits until a message has left, not for one to come */
    int32_t from; /* the node from which the message must be; TRACE_NONE: from any, or not known */
};

struct trace_handler {
    vtime due, begin, end;
    vtime entered, left; /* the program's function runs between both; before and behind it the system */
    int32_t node;
    int32_t type;    /* of the message */
    int32_t message; /* into trace.messages: that it was run for; TRACE_NONE: not in the trace */
    int32_t stack;   /* of the program where it was interrupted; TRACE_NONE: not known */
    bool unfinished;
};

struct trace_system {
    vtime begin, end;
    /* when the program was charged with it: before begin, if the system had other work to do first */
    vtime charged;
    int32_t node;
    enum trace_task task;
};

/* The times of a message. VT_NEVER: it had not come so far when the run, or the trace, ended. */
struct trace_message {
    int32_t from, to; /* into trace.nodes; TRACE_NONE: a service (an I/O node), or the host's service */
    uint32_t from_address, to_address; /* in the network: topo.h */
    int32_t type;
    int32_t pid; /* process type: of MPI, the communicator (nx_api/waitfor/waitfor_mpi.c) */
    uint64_t bytes;
    bool is_long;  /* it asks first: request to send, clear to send, data */
    vtime sent;    /* the sender's system is done with the call's part */
    vtime asked;   /* long: the request has come to the receiver */
    vtime granted; /* long: the receiver sends the clear to send */
    vtime entered; /* it asks for the first channel */
    vtime moved;   /* it has its whole path: the first byte moves */
    /* it gives back the channels between nodes before it has left (channel.h); VT_NEVER: it does not */
    vtime freed;
    vtime left;              /* its tail has passed */
    vtime complete;          /* the receiver's system is done with it: a receive may return it */
    vtime taken;             /* it is in the program's memory */
    int32_t sending, taking; /* the calls that did so, into trace.calls; TRACE_NONE: not known, or none did */
    int32_t first_block, blocks; /* into trace.blocks */
};

struct trace_block {
    vtime begin, end;
    int32_t message;
    uint32_t channel; /* of the network: topo.h */
};

struct trace_node {
    char name[16]; /* "node 3", "host" */
    uint32_t address;
    vtime end; /* of its program; of the trace, if the program had not ended */
    /* its parts of the tables, which are sorted by node, then by time of beginning */
    int32_t first_call, calls, first_handler, handlers, first_system, systems;
    int32_t first_wait, waits;
    bool traced; /* false: the trace was made with --trace-nodes, without this node */
};

struct trace_stacks; /* where programs were: trace_stack() */

struct trace {
    char *path; /* of the file */
    char *program, *machine,
        *command;    /* what ran: path; name of the machine; the whole command, for people */
    char **argv;     /* the whole command, ended by NULL; argv[0] is touchstone */
    char **layer;    /* patterns of its message layer (guest/layer.h), ended by NULL */
    char *folder;    /* in which it ran */
    char *version;   /* of touchstone */
    vtime from, to;  /* what is in memory: to == end unless the trace was cut */
    vtime end;       /* of the run */
    uint64_t digest; /* of the run */
    bool complete;   /* false: the file ends early, the run was killed */
    struct topo topo;
    char **names;              /* of calls */
    enum trace_class *classes; /* of names */
    int32_t name_count;
    struct trace_node *nodes;
    struct trace_call *calls;
    struct trace_wait *waits;
    struct trace_handler *handlers;
    struct trace_system *systems;
    struct trace_message *messages;
    struct trace_block *blocks;
    int32_t node_count, call_count, wait_count, handler_count, system_count, message_count, block_count;
    struct trace_stacks *stacks;
};

/* What to read of a trace. All 0 and NULL: all of it. */
struct trace_selection {
    vtime from, to;    /* what overlaps [from, to]; to 0: to the end */
    const bool *nodes; /* by number, node_count of them; NULL: all. Messages with an end at one of them */
    uint32_t node_count;
    bool host; /* the host, too, if nodes is not NULL */
};

/* Reads a trace. NULL with *error (malloc'd, names the file) on failure, or if it has none of the nodes. */
struct trace *trace_load(const char *path, const struct trace_selection *s, char **error);
/* Had the node, or host, a program? With a host, a node has one when the host has loaded it. */
bool trace_node_ran(const struct trace *t, int32_t node);
/* How many nodes had a program; the host is none of them. */
int32_t trace_nodes_ran(const struct trace *t);
void trace_free(struct trace *t);
/* Is the node, or host, selected? */
bool trace_selects(const struct trace *t, const struct trace_selection *s, int32_t node);
/* Has the trace one of the nodes selected? False with *error, malloc'd. */
bool trace_has_nodes(const struct trace *t, const struct trace_selection *s, char **error);

/* --- where a node's time went --- */

enum trace_state {
    TRACE_COMPUTING,
    TRACE_IN_CALL,   /* the operating system works for the program's call */
    TRACE_WAITING,   /* in a call, with the processor idle */
    TRACE_IN_SYSTEM, /* the operating system works for a message, which the program did not ask for now */
    TRACE_ENDED,     /* without a program */
    TRACE_STATES
};

/* A part of a node's time. Pieces of a node follow each other without gap, and fill the time from
 * trace.from to trace.to. */
struct trace_piece {
    vtime begin, end;
    enum trace_state state;
    bool in_handler; /* of a handler, or of a call that a handler made */
    int32_t call; /* of TRACE_IN_CALL, TRACE_WAITING; and of TRACE_IN_SYSTEM within a call; else TRACE_NONE */
    int32_t wait; /* of TRACE_WAITING */
    int32_t handler; /* if in_handler */
    int32_t system;  /* of TRACE_IN_SYSTEM, unless the system enters or leaves a handler */
};

struct trace_pieces {
    struct trace_piece *list;
    size_t count;
};

/* Appends the pieces of a node (all of them: p->list is freed by the caller). */
void trace_pieces(const struct trace *t, int32_t node, struct trace_pieces *p);
/* "computing", "in call" ... */
const char *trace_state_name(enum trace_state s);

/* --- where in the program --- */

struct trace_frame {
    const char *function; /* "relax"; "" if the program has no symbols */
    const char *file;     /* as the compiler was given it, "relax.c"; NULL: no line is known */
    int line;             /* from 1 on; 0: not known */
    int64_t returns_to;   /* the address in the program that the frame's call returns to */
    bool library;         /* a function of NX's library, such as gsync, which the linker added */
    bool layer;           /* of the message layer that the run was given */
};

/* The file of a program of the run that is younger than the trace, whose path is given: functions and lines
 * are looked up in it, but may be of another program. NULL: there is none. */
const char *trace_younger_program(const struct trace *t, const char *path);
/* The file of a program of the run that cannot be read, as one that has gone. NULL: there is none. */
const char *trace_missing_program(const struct trace *t);

/* The frames of a stack, innermost first, found when first asked for; *count of them. The program's file must
 * still be there: otherwise no frames. */
const struct trace_frame *trace_stack(const struct trace *t, int32_t stack, int *count);
/* The communicator of MPI's messages of a process type, "MPI_COMM_WORLD", malloc'd; NULL: they are none. */
char *trace_communicator(int32_t pid);
/* The innermost frame that is not the library's, and that reports name (guest/layer.h); NULL: none is
 * known. */
const struct trace_frame *trace_place(const struct trace *t, int32_t stack);
/* What a program may have worked in between two places, stacks of one node: `in`, the innermost function that
 * was at both and did not return in between (NULL: not known), and the functions that have a loop on the way,
 * or are called there and have loops or calls: of `in`, of those that returned since the first place, and of
 * those called until the second. before: TRACE_NONE: the beginning of the program, or of the handler; after:
 * TRACE_NONE: its end. */
enum { TRACE_MOST_WORKED = 4 };
struct trace_between {
    const struct trace_frame *in;
    const char *worked[TRACE_MOST_WORKED];
    int count;
    bool more; /* there are others, too */
};
struct trace_between trace_between(const struct trace *t, int32_t before, int32_t after);
/* Where the program, or the handler, was around a piece of its node: stacks, or TRACE_NONE. */
struct trace_around {
    int32_t before; /* its last call before the piece; TRACE_NONE: it begins */
    int32_t after;  /* the call of the piece, or the next call, or where the next handler interrupts it */
    int32_t seen;   /* computing: where a handler beside the piece interrupted it; TRACE_NONE: none did */
};
/* Finds it for all `count` pieces of a node. */
void trace_around(const struct trace *t, const struct trace_piece *list, size_t count,
                  struct trace_around *around);
/* What the program called: "csend", or the library's function that did it for the program: "gsync". */
const char *trace_called_name(const struct trace *t, const struct trace_call *c);
/* Is the call's type the id that it was given, as msgwait's and iowait's is? */
bool trace_takes_id(const struct trace *t, const struct trace_call *c);

/* --- channels --- */

/* Calls use() for each interval in which a message held a channel of its path, in no order. */
typedef void trace_use(void *ctx, uint32_t channel, int32_t message, vtime begin, vtime end);
void trace_channel_uses(const struct trace *t, trace_use *use, void *ctx);
/* What a channel (topo_channel() of net/topo.h) is: "node 3 -> node 7", "node 3 into the network", "node 7
 * out of the network". Writes at most size bytes; returns buf. */
const char *trace_channel_name(const struct trace *t, uint32_t channel, char *buf, size_t size);
#endif
