/* waitfor.h - the analysis of why nodes stand still: the wait-for graph of a machine at quiescence, when
 * every program waits and no message is under way.
 *
 * A back end (the simulator, or NX on MPI) fills in a struct waitfor: what each node waits for, what lies in
 * its mailbox, what it has posted. waitfor_analyse() finds for each waiting node the cause of its wait, and
 * the cycle if there is one. The reports are the same on all back ends: text, and JSON.
 *
 * Who could end a wait. Three kinds of waits are told apart:
 *
 *     one       for one certain node: crecvx from a node, a send whose receiver has no room
 *     any       for a message that any other node could send (the OR model of Knapp, "Deadlock detection in
 *               distributed databases", ACM Computing Surveys 19, 1987)
 *     all       in a global operation, for all nodes that have not come to it (the AND model)
 *
 * A cycle is one of waits of the kinds one and all: each node of it waits for the next whatever else happens.
 * A wait of kind any could be ended by many; if each of these waits, and waits in the end for one of the
 * first again, they are a knot.
 *
 * No function here depends on anything but the C library: programs on MPI are linked with them. None returns
 * without memory; abort() then. */
#ifndef WAITFOR_WAITFOR_H
#define WAITFOR_WAITFOR_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum { WAITFOR_ANY = -1 };
#define WAITFOR_NEVER UINT64_MAX

enum waitfor_state {
    WAITFOR_NO_PROGRAM, /* it never had one */
    WAITFOR_WAITS,      /* in a call */
    WAITFOR_COMPUTES,   /* outside of calls: only in reports at a limit */
    WAITFOR_ENDED
};

/* What a waiting node waits for. */
enum waitfor_what {
    WAITFOR_MESSAGE, /* that `select` selects */
    WAITFOR_BUFFER,  /* a send to `to` has not left its buffer: the receiver has no room, or has not asked */
    WAITFOR_END,     /* of the program on node `to` (WAITFOR_ANY: on any; with `of_all`: on all others) */
    WAITFOR_HANDLER, /* an interrupt */
    WAITFOR_OTHER,   /* a time, the host: `call` says */
    WAITFOR_FILE     /* other nodes' calls on a file whose pointer they share (I/O modes 1 to 4) */
};

struct waitfor_select {
    long typesel; /* as in nx.h */
    long node;    /* WAITFOR_ANY, or the sender */
    long pid;     /* WAITFOR_ANY, or the sender's process type */
};

/* A message that has come and that no receive has selected. */
struct waitfor_message {
    long type, from, pid;
    size_t bytes;
    uint64_t sent_ps, came_ps; /* WAITFOR_NEVER: not known */
    bool held_back;            /* long, and there is no room for it: its sender still has it */
    bool of_window;            /* MPI: the library has sent it, for a window */
};

/* A receive that is posted: irecv, or hrecv if it has a handler. */
struct waitfor_receive {
    struct waitfor_select select;
    bool has_handler;
    bool filled;      /* its message is here: the program has not asked for it, or its handler has not run */
    long type, from;  /* of that message */
    const char *line; /* where it was posted, or of its handler; NULL: not known */
};

/* What happened to a message that the node does not have any more. */
enum waitfor_fate {
    WAITFOR_RECEIVED,  /* a receive took it */
    WAITFOR_HANDLED,   /* a receive with a handler */
    WAITFOR_FLUSHED,   /* flushmsg threw it away */
    WAITFOR_DISCARDED, /* its type is a forced one, and no receive was posted when it came */
};

/* One of the last messages that the node had and has not any more. */
struct waitfor_taken {
    enum waitfor_fate fate;
    long type, from, pid;
    size_t bytes;
    struct waitfor_select by; /* the receive's; all WAITFOR_ANY if none took it */
    const char *call;         /* "crecv", "msgwait", "hrecv"; NULL: not known */
    const char *line;         /* NULL: not known */
    uint64_t came_ps;         /* WAITFOR_NEVER: not known */
};

/* Who could end a node's wait. */
enum waitfor_who {
    WAITFOR_NOBODY,
    WAITFOR_ONE_NODE,  /* `whom` only */
    WAITFOR_ANY_NODE,  /* each of the other nodes that have not ended */
    WAITFOR_ALL_NODES, /* only together: all nodes that are not in `operation` */
};

enum waitfor_cause {
    WAITFOR_WRONG_TYPE,     /* a message from the node it waits for is here, of another type */
    WAITFOR_WRONG_NODE,     /* a message of the type is here, from another node or process */
    WAITFOR_TAKEN,          /* another receive of this node took a message that would have ended the wait */
    WAITFOR_MASKED,         /* a handler is due, and masked for ever */
    WAITFOR_BUFFERS_FULL,   /* the receiver has no room for the message */
    WAITFOR_NODE_HAS_ENDED, /* all that could have ended the wait, or one that had to, have ended */
    WAITFOR_CYCLE,          /* none of the above, and it is in a cycle */
    WAITFOR_KNOT,           /* or in a knot: each waits for a message that any other could send */
    WAITFOR_BEHIND,         /* it waits for a node that waits for another reason */
    WAITFOR_ORPHAN,         /* nobody has sent it, and none of the above */
    WAITFOR_CAUSES
};

/* Texts belong to the struct waitfor (waitfor_text), arrays too (waitfor_add_...). */
struct waitfor_node {
    const char *name; /* for people: "node 3", "host" */
    long number;      /* its index in struct waitfor. The host's, which is the last, is the number of nodes */
    bool is_host;
    enum waitfor_state state;
    const char *call; /* "crecv"; NULL: it computes */
    bool has_type;    /* the call was given a type, typesel or id, for reports */
    long type;
    uint64_t since_ps; /* in the call, or ended, since; of virtual time, or of time since the program began */
    int exit_status;   /* ended: other than 0 if by exit with an error */
    const char *line;  /* "ring.c:17", NULL: not known */
    const char **stack; /* of lines "exchange() at ring.c:17", the innermost first */
    size_t stack_count;

    /* What a waiting node waits for: of several things the first that is not there. */
    enum waitfor_what what;
    struct waitfor_select select;
    long to;
    bool of_all;
    size_t to_bytes; /* of the send */
    bool to_held;    /* MPI: the send waits for its receive, not for room */
    bool in_window;  /* MPI: the message is one of a window */
    bool is_locked;  /* MPI: it waits for a lock, which node `holder` has */
    long holder;

    bool masked, in_handler;
    uint32_t due;                        /* handlers that are to run, and cannot */
    size_t buffered_bytes, buffer_bytes; /* unexpected messages held, and the room there is; 0, 0: no limit */
    struct waitfor_message *messages;
    size_t message_count; /* of those listed, at most WAITFOR_MOST_MESSAGES */
    uint64_t more_messages;
    struct waitfor_receive *receives;
    size_t receive_count;
    struct waitfor_taken *taken; /* the latest last */
    size_t taken_count;

    /* By waitfor_analyse(), of a node that waits. */
    const char *operation; /* the global operation it is in, "gsync"; NULL: none */
    enum waitfor_who who;
    uint32_t whom;
    bool in_cycle;  /* w->cycle */
    bool in_circle; /* that one or another in which each waits for one node */
    enum waitfor_cause cause;
    const char
        *why; /* for people: what it waits for, what is here, in what that differs; lines of sentences */
    const char *remedy; /* what to look at or to change; NULL: none */
};

enum { WAITFOR_MOST_MESSAGES = 64 };

struct waitfor {
    uint32_t count; /* of nodes, and the host if there is one, which is the last */
    struct waitfor_node *nodes;
    const char *program; /* for people; NULL: not known */
    uint64_t now_ps;
    const char *clock;  /* "virtual time", or "time since the program began" */
    bool may_lack_host; /* nobody has received anything, and the program knows of a host, but none is there */
    /* By waitfor_analyse(). */
    uint32_t *cycle; /* a shortest cycle: each waits for the next, the last for the first. NULL: none */
    uint32_t cycle_count;
    uint32_t circles; /* how many cycles are there in which each waits for one node */
    bool knot;        /* no cycle is there, but all that wait are a knot */
    struct waitfor_window {
        long context;
        const char *name; /* NULL: none */
    } * windows;          /* MPI's */
    size_t window_count;
    struct waitfor_texts *texts;
};

/* `count` nodes without a program, named "node 0" and so on. */
struct waitfor *waitfor_new(uint32_t count);
void waitfor_free(struct waitfor *w);
/* A copy of the text, which lasts as long as w; NULL for NULL. */
const char *waitfor_text(struct waitfor *w, const char *text);
/* At most WAITFOR_MOST_MESSAGES are listed, more are counted. Those of NX's library itself, which programs do
 * not see, may be among them. */
void waitfor_add_message(struct waitfor_node *n, const struct waitfor_message *m);
void waitfor_add_receive(struct waitfor_node *n, const struct waitfor_receive *r);
void waitfor_add_taken(struct waitfor_node *n, const struct waitfor_taken *t);
/* A window of MPI's, by the process type of its messages, and its name; again, if it is there. */
void waitfor_add_window(struct waitfor *w, long context, const char *name);
/* The next frame of the stack, outwards. */
void waitfor_add_frame(struct waitfor *w, struct waitfor_node *n, const char *line);

/* Once, when all nodes are filled in. In time proportional to the nodes, times the global operations that
 * they are in. */
void waitfor_analyse(struct waitfor *w);
/* Does node a wait, and could b end that (one, any), or must b be among those that do (all)? */
bool waitfor_needs(const struct waitfor *w, uint32_t a, uint32_t b);
/* The cause's name in reports: "cycle", "wrong type" ... */
const char *waitfor_cause_name(enum waitfor_cause c);

/* Reports, of an analysed w. In the text, nodes in the same state and of the same cause are one line. No
 * newline at the end of either. */
void waitfor_write_text(const struct waitfor *w, FILE *f);
void waitfor_write_json(const struct waitfor *w, FILE *f);

/* The name of the global operation whose messages have this type; NULL: the type is a program's. */
const char *waitfor_operation(long type);
#endif
