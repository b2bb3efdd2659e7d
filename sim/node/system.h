/* system.h - what all nodes of one machine share. Made and owned by machine/; nodes only use it. */
#ifndef NODE_SYSTEM_H
#define NODE_SYSTEM_H
#include "config/config.h"
#include "kernel/bounds.h"
#include "kernel/cache.h"
#include "kernel/evq.h"
#include "kernel/pool.h"
#include "net/protocol.h"
#include "node/file.h"
#include "node/node.h"

enum node_stop { STOP_NOT, STOP_FAILED, STOP_KILLED, STOP_VIRTUAL_TIME, STOP_WALL_TIME, STOP_INTERRUPTED };

enum { NODE_HOST_FILES = 64 };

struct node_absent {
    char *function, *first; /* the node that called it first */
    uint64_t calls;
};

struct node_system {
    const struct cfg_machine *cfg;
    struct evq *q;
    struct bounds checks;   /* beside it: computing nodes' next checks for messages: cpu.h */
    struct instant present; /* the event that happens now, or was the last, or a turn in passing */
    struct instant reached; /* the latest of those before: turns.h */
    struct protocol *protocol;
    struct topo topo;
    const struct node_fs *fs; /* the machine's file system, NULL none: file.h */
    struct cfs *cfs;          /* the same, for NX's own calls on it: cfs/cfs.h */
    struct node **nodes;
    struct pool made, made_beside; /* what nodes are made of; to be freed behind them */
    struct node_region *roomy;     /* regions of address space with room for more nodes: span.h */
    uintptr_t last_region;         /* the latest that lies where all are meant to; 0: none */
    bool isolate;                  /* only `writable` may write to its memory: isolate.h */
    struct node *writable;         /* NULL: none */
    enum node_guards guards;       /* the least that any region has */
    size_t most_mappings; /* not 0: as if the host allowed so many, and had no lighter guards; for tests */
    struct node *host;    /* the node that runs the host program, NULL: none. Its number is count. */
    struct cube *cube;    /* what a host program does with the nodes, NULL: all have been loaded: cube.h */
    uint32_t count;       /* nodes; with a host program: of its cube, 0 when it has none */
    uint32_t running;     /* programs */
    bool flushes;         /* one of them may throw away messages of others */
    uint32_t await_ends;  /* of them are in calls that wait for another's end */

    enum node_stop stop;    /* why the machine stops before its programs have ended */
    struct instant stop_at; /* STOP_FAILED: the failed program's; STOP_VIRTUAL_TIME: the limit */
    uint32_t switches;      /* to programs, modulo 2^32 */
    uint32_t unseen; /* calls since the scheduler had control: it looks at the wall clock and the keyboard */

    /* the first failure, for the user; NULL none */
    char *failure;

    /* output: a FILE for each of fd 1 and 2, written in the order of virtual time */
    FILE *out[2];

    uint64_t digest;          /* of all messages received: time, nodes, type, length, in order */
    FILE *history;            /* the same as text, a line for each; NULL: not wanted */
    uint64_t messages, bytes; /* received */
    char **
        host_files; /* names of files outside of /cfs that programs have used, each once; ended by NULL, or NULL */
    struct node_absent *absent; /* functions that nodes do not have, and programs called; by first call */
    size_t absent_count;
    size_t host_file_count; /* at most NODE_HOST_FILES: of more, the first */

    /* Threads look at what follows all the time: apart from what the committing one writes. */
    char apart[CACHE_LINE];
    vtime max_time;      /* VT_NEVER: none */
    vtime longest_slice; /* not 0: computing is stopped at least so often, for tests: it changes no result */
    /* Set by the machine; all may be NULL. */
    struct workers *workers;            /* for programs that compute ahead: cpu.h */
    void (*keep_crash)(struct node *n); /* n->crash has been set, on the calling thread, and would not last */
    void (*crashed)(struct node *n);    /* at its place in the order of events: reports n->crash */
    void (*look)(void *ctx);            /* at the world outside, which may want the machine to stop */
    void *look_ctx;
};

/* Who lives at a place of the network, and the number by which programs know them. */
static inline struct node *node_at(const struct node_system *sys, uint32_t place)
{
    return sys->host && place == sys->host->place ? sys->host : sys->nodes[place];
}
static inline uint32_t node_number(const struct node_system *sys, uint32_t place)
{
    return sys->host && place == sys->host->place ? sys->count : place;
}

/* Record the first failure (printf-like), and stop the machine with `why`. */
void node_system_fail(struct node_system *sys, enum node_stop why, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));

/* Notes a call of a function that nodes do not have, by a node of that name. In the order of events. */
void node_system_note_absent(struct node_system *sys, const char *function, const char *node);

/* Nothing is left to happen but what comes after the limit of virtual time: stops the machine there. */
void node_system_end_at_limit(struct node_system *sys);

/* A message has arrived: into the digest. */
void node_system_digest(struct node_system *sys, const struct message *m, vtime now);

/* Make a node with its program loaded, ready to start at time 0. NULL with *error set. */
struct node *node_new(struct node_system *sys, uint32_t id, const struct node_image *img, int argc,
                      char **argv, char **envp, char **error);
void node_delete(struct node *n);
/* The same without a program: it has ended before it began. Messages wait for the one to be loaded. */
struct node *node_new_empty(struct node_system *sys, uint32_t id);
/* The host, at its place. */
struct node *node_new_host(struct node_system *sys, uint32_t place, const struct node_image *img, int argc,
                           char **argv, char **envp, char **error);
/* Makes n, a new node, the one that comes after `before`, whose program has ended: its books go on in n, and n gets the
 * messages that wait. Time is t. */
void node_succeed(struct node *n, struct node *before, vtime t);

/* --- for the protocol: struct protocol_nodes with ctx = the node_system --- */
vtime node_work(void *ctx, uint32_t node, enum protocol_task task, vtime at, vtime t);
void node_move(void *ctx, uint32_t node, enum protocol_task task, vtime t);
bool mailbox_envelope(void *ctx, struct message *m, vtime now);
void mailbox_sent(void *ctx, struct message *m, vtime now);
void mailbox_arrived(void *ctx, struct message *m, vtime now);
#endif
