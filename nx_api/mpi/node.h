/* node.h - a node of a program that runs on MPI: one process, which is one rank. Behind the calls of nx_api/calls, in place
 * of the simulator (calls/backend.h).
 *
 * All MPI is done by the program's own thread: in NX calls (node_enter, node_wait, node_leave) and at the checks that nxcc
 * puts into loops and functions (nxc_preempt). There, and only there, messages are taken from MPI into the mailbox and
 * handlers run; so no handler can interrupt the C library. A second thread makes the checks strike now and then (tick.h).
 */
#ifndef MPI_NODE_H
#define MPI_NODE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "nx_api/calls/mailbox.h"
#include "nx_api/include/estat.h"
#include "nx_api/include/host.h"
#include "nx_api/include/nx.h"

/* The last error of an NX call. */
struct node_error {
    int code;
    char text[256];
};

struct node_system {
    uint32_t count;
    struct node *host; /* NULL: no host program runs */
};

/* The end of a process, as its node has told. */
struct node_end {
    bool ended, noticed; /* noticed: waitall or waitone has told of it */
    long pid, status;
    uint64_t order; /* 1: it was the first to be heard of */
};

struct node {
    long id, pid;
    struct node_system *sys;
    struct node_info info;
    struct node_error error[1]; /* the calls find it by n->error->, wherever a backend keeps it */
    const char *call;           /* NULL while it computes */
    long call_type;             /* type, typesel or id it was given */
    bool call_has_type;
    int saved_errno;
    bool masked, in_handler;
    bool killed; /* is to end at the next call or check */
    bool over;   /* its program runs no more; messages are thrown away */
    bool returned;
    long exit_code; /* of main, if it has returned */
    struct mailbox *mailbox;
    struct receive receive; /* of the blocking call that it is in, outside of handlers */
    struct own_calls own;   /* of other calls */
    struct node_end *ends;  /* of all nodes */
    uint64_t ended;         /* how many of them */
};

extern struct node node_me;

static inline struct node *node_self(void)
{
    return &node_me;
}

/* An element of a program's array of longs: of 4 bytes in programs compiled with nxcc --long32. */
extern int node_long_bytes;
long node_get_long(const struct node *n, const long *array, size_t i);
void node_put_long(const struct node *n, long *array, size_t i, long value);

void node_enter(struct node *n, const char *call);
static inline void node_enter_early(struct node *n, const char *call)
{
    node_enter(n, call);
}
void node_leave(struct node *n);
void node_order(struct node *n);
void node_wait(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg);
long node_error(struct node *n, int code, const char *fmt, ...) __attribute__((format(printf, 3, 4)));
/* Says what is wrong, and ends the program on all nodes, with status 1. */
_Noreturn void node_fail(struct node *n, const char *fmt, ...) __attribute__((format(printf, 2, 3)));
/* Ends this process as if it were killed: what it has printed is printed. */
_Noreturn void node_end_here(struct node *n);
/* Seconds since the program began. */
double node_seconds(void);

/* How programs reach the faces of the calls (nx_api/calls/call.c), and what libnx.a has in place of the C library's. Weak:
 * a program may have names of its own. */
#define NX_EXPORT(name) __asm__(name) __attribute__((weak, visibility("default")))
#define NX_CALL(name, parameters, arguments)                                                                 \
    long node_##name parameters NX_EXPORT(#name);                                                            \
    long node__##name parameters NX_EXPORT("_" #name);
#define NX_VALUE(name, expression)                                                                           \
    long node_##name(void) NX_EXPORT(#name);                                                                 \
    long node__##name(void) NX_EXPORT("_" #name);
#define NX_OTHER(name)
typedef int32_t word;
typedef uint32_t size_word;
#include "nx_api/calls/calls.def"
#undef NX_CALL
#undef NX_VALUE
#undef NX_OTHER
#endif
