/* backend_node.h - MPI's part of nx_api/contract/backend.h: its node, which is one process and one rank, and
 * its messages.
 *
 * The program's own thread makes all MPI calls: in NX calls (node_enter, node_wait, node_leave) and at the
 * polls that nxcc puts into loops and functions (nxc_preempt). There, and only there, messages are taken from
 * MPI into the mailbox and handlers run; so no handler can interrupt the C library. Senders make the polls
 * strike (bells.h), and a second thread does so now and then (tick.h). Other threads read and write files
 * (io_jobs.h).
 */
#ifndef MPI_BACKEND_NODE_H
#define MPI_BACKEND_NODE_H
#include "nx_api/contract/backend.h"
#include "nx_api/include/host.h"
#include "nx_api/include/nx.h"

struct mpi_system {
    uint32_t count;
    struct node *host; /* NULL: no host program runs */
};

/* The end of a process, as its node has reported. */
struct mpi_end {
    bool ended, noticed; /* noticed: waitall or waitone has reported the end */
    long pid, status;
    uint64_t order; /* 1: the first end that this node heard of */
};

/* The call that the program is in. A handler makes calls of its own; afterwards this is again what it was. */
struct mpi_call {
    const char *name; /* NULL while the program computes */
    long type;        /* the type, typesel or id the call is about, if has_type */
    bool has_type;
    uintptr_t caller; /* the address in the program behind the call; outside of calls that of the last one */
};

struct node {
    long id, pid;
    struct mpi_system *sys;
    struct node_info info;
    struct node_error error;
    struct mpi_call call;
    int saved_errno;
    bool masked, in_handler;
    bool names_senders; /* a receive has selected a certain sender */
    bool killed;        /* is to end at its next call or poll */
    bool killed_alone;  /* and the others go on */
    bool over;          /* its program has ended; messages are thrown away */
    bool returned;
    long exit_code; /* of main, if returned */
    struct mpi_mailbox *mailbox;
    struct receive receive; /* of the blocking call that the program is in, outside of handlers */
    struct own_calls own;   /* of other calls */
    struct mpi_end *ends;   /* by node */
    uint64_t ended;         /* how many of them have */

    /* For reports, while the program is in node_wait. */
    bool (*ready)(struct node *n, void *arg);
    void *ready_for; /* its argument */
    double since;    /* seconds since the program began: at rest, or ended */
};

/* A message that has come, or whose head has come. Its bytes are in the packet it came in, in a block of
 * memory, or in the buffer of the receive that waits for it. */
struct message {
    struct message *next;
    long type, pid;
    uint32_t source;
    bool whole; /* its bytes have come */
    bool lost;  /* to be freed when it is whole */
    size_t bytes;
    uint64_t come;    /* of those that have come to this node */
    uint64_t nth;     /* of those that its sender has sent here, if the run is recorded */
    const char *data; /* if it is whole */
    void *block;      /* malloc'd: freed with the message */
    struct packet *packet;
    struct receive *taker; /* that has selected it */
};

extern struct node mpi_me;

static inline struct node *node_self(void)
{
    return &mpi_me;
}

/* How programs reach the entry points of calls (nx_api/calls/call.c), and what libnx.a has in place of the C
 * library's functions. Weak: a program may have names of its own. */
#define NX_EXPORT(name) __asm__(name) __attribute__((weak, visibility("default")))
#define NX_EXPORT_LONG32(name) __asm__(name) __attribute__((visibility("default")))
#define NX_CALL(name, parameters, arguments)                                                                 \
    long node_##name parameters NX_EXPORT(#name);                                                            \
    long node__##name parameters NX_EXPORT("_" #name);
#define NX_VALUE(name, expression)                                                                           \
    long node_##name(void) NX_EXPORT(#name);                                                                 \
    long node__##name(void) NX_EXPORT("_" #name);
#define NX_OTHER(name)
#include "nx_api/contract/calls.def"
#undef NX_CALL
#undef NX_VALUE
#undef NX_OTHER
#endif
