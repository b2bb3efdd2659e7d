/* core.h - what MPI's library, which is a part of the node program (mpi_api/lib), asks of the system.
 * Programs do not call these.
 *
 * A message's tag is its NX type, the context of its communicator its process type; of one source and context
 * messages are received in the order sent. A context is used by two halves: point to point, and collectives.
 *
 * Times: each call takes what NX's calls take (machine file: system); what the library computes is counted as
 * the program's own. */
#ifndef MPI_CORE_H
#define MPI_CORE_H
#include <stdbool.h>

/* MPI's calls by number, for reports; the last: none of them. */
enum nxm_call {
#define MPI_DECLARE(name, parameters) CALL_##name,
#include "mpi_api/include/mpi_calls.h"
#undef MPI_DECLARE
    CALL_Other
};

/* NX's messages have other process types, unless a program gives itself one of so many. */
enum { NXM_FIRST_CONTEXT = 1 << 24 };
static inline bool nxm_is_collective(int context)
{
    return context & 1;
}

/* What a message is sent with, or a receive selects: tag and node may be -1 there, any. */
struct nxm_envelope {
    int call, tag, node, context;
};

/* What is known of a receive or send that is done. */
struct nxm_status {
    int done;
    int arrived;   /* of one that a test has left: could be done */
    int truncated; /* the message was longer than the buffer, and is lost */
    int tag, node;
    long bytes;
};

/* Waits for, or tests, those of `count` ids that are not 0. Of those that are done, it puts the messages into
 * their buffers, sets the status, and gives the ids back. */
enum nxm_how {
    NXM_WAIT = 1, /* else: looks once */
    NXM_ALL = 0,  /* all, or (a test) none of them */
    NXM_ANY = 2,  /* the first that is done */
    NXM_SOME = 4, /* all that are done */
    NXM_LEAVE = 8 /* none is taken: it is only waited for */
};
struct nxm_completion {
    int call, how, count;
    const int *ids;
    struct nxm_status *status; /* count of them: done, or not */
};

/* Sends; returns when the buffer may be used again; `held`: when a receive has taken the message. The second
 * returns an id, or 0: it is done. */
long nxm_send(const struct nxm_envelope *e, const void *buf, long len, int held);
long nxm_isend(const struct nxm_envelope *e, const void *buf, long len, int held);
/* Receives; the second returns an id. */
long nxm_recv(const struct nxm_envelope *e, void *buf, long room, struct nxm_status *status);
long nxm_irecv(const struct nxm_envelope *e, void *buf, long room);
/* Another buffer for a receive that is not done. */
long nxm_receive_into(int id, void *buf, long room);
/* 1: those asked for are done; 0: they are not. */
long nxm_complete(const struct nxm_completion *c);
/* Looks for a message that a receive would take, or waits for it. 1: found. */
long nxm_probe(const struct nxm_envelope *e, int wait, struct nxm_status *status);
/* Withdraws a receive, unless it has its message. 1: withdrawn, and the id is given back. */
long nxm_cancel(int call, int id);
/* --- files: moves.c of nx_api/sim --- */

/* Bytes between memory and an open file, at an offset, in the time of its file system. */
struct nxm_move {
    int call, fd, write;
    long at, bytes;
    void *buf;
};
/* How many bytes have been moved, fewer at the end of the file; -1 with errno. The second begins, has copied
 * what is written, and returns an id, 1 or more, for the third, which waits, or answers NXM_UNDER_WAY. */
enum { NXM_UNDER_WAY = -2 };
long nxm_move(const struct nxm_move *m);
long nxm_imove(const struct nxm_move *m);
long nxm_moved(int call, long id, int wait);

/* Ends the run with this message. */
long nxm_fail(int call, const char *text);
/* A number of the machine file; which of the run's programs this is, from 0. */
enum nxm_number { NXM_EAGER_LIMIT, NXM_COLLECTIVES, NXM_PROGRAM };
long nxm_number(enum nxm_number which);
#endif
