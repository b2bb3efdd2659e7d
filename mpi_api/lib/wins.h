/* wins.h - windows: memory of each rank of a communicator that the others read and write (one-sided
 * communication).
 *
 *   calls        wins.c          making and freeing; what is known of a window
 *                win_calls.c     Put, Get, Accumulate and kin: each is an access
 *   accesses     win_access.c    an access as messages, and what the target does with them
 *   when         win_active.c    the target takes part: fence; post, start, complete, wait
 *                win_passive.c   it does not: locks, served by a handler, which interrupts its program
 *
 * In active epochs accesses are kept until the call that ends the epoch, and sent then; the target carries
 * them out in its fence, or, from post to wait, in any call that waits. In passive ones they are sent at
 * once. All messages go in the context of the window's communicator. Accesses of one rank to another are
 * carried out in their order. */
#ifndef MPI_WINS_H
#define MPI_WINS_H
#include "coll.h"

/* What a rank does to another's memory: its elements there become `op` of them and those sent; before, those
 * that were there are fetched. */
struct access {
    struct access *next;
    int call;
    bool sends, fetches;
    MPI_Op op;           /* MPI_REPLACE: Put; MPI_NO_OP: Get */
    const void *compare; /* NULL: none; else MPI_REPLACE, if the element there equals this one */
    const void *buf;
    int count;
    MPI_Datatype type;
    void *into;
    int room;
    MPI_Datatype as;
    int rank; /* the target */
    MPI_Aint place;
    int their_count;
    MPI_Datatype their_type;
    MPI_Datatype element; /* set by a check, if elements are combined: their type; */
    bool whole;           /* with their holes */
};

/* A message that may be on its way, or an answer that is waited for. */
struct pending {
    struct pending *next;
    int id, rank;
    void *memory; /* NULL, or what the message is in: freed when it is done */
    /* With `into`: memory is what an access has fetched, all of it, when this is done. */
    void *into;
    int room;
    MPI_Datatype as, whole; /* whole: pairs of this type, with their holes */
};

struct win *win_of(MPI_Win handle); /* NULL: none */
int fail_win(struct win *w, int call, int code, const char *fmt, ...) __attribute__((format(printf, 4, 5)));
int fail_no_win(int call);
/* An error if an epoch of the rank goes on, other than of fences. */
int win_check_idle(struct win *w, int call);

/* --- accesses --- */

enum { ASK = 1, ACCESS, TOKEN, FETCHED, ANSWER }; /* tags */
enum { MOST_BYTES = 16384 }; /* of a message for a handler or a task: their buffers have room for it */

/* What a message says of itself; behind it come the spans of the target's memory, and the data, which lie as
 * aligned as malloc's memory does: copies of long doubles need that. */
struct win_head {
    _Alignas(16) enum { MOVE, COMPARE, DONE, LOCK, UNLOCK, FLUSH, END } what;
    int op, element; /* handles */
    bool sends, fetches;
    int spans;
    int call, kind; /* kind: of the lock */
};
struct win_span {
    MPI_Aint at;
    size_t bytes;
};

/* Sends an access as messages of this tag, of at most so many bytes behind the head. They are pending then,
 * and their answers. */
void access_send(struct win *w, const struct access *a, int tag, size_t most);
/* How many messages it would be, if there is no limit. */
int access_messages(const struct access *a);
/* Carries out a message that has come from a node. */
void access_carry_out(struct win *w, char *message, int node);
/* Waits for what is pending: of one rank, or (-1) of all. */
void access_wait(struct win *w, int call, int rank);
/* Sends a message without data at once; or so that it is pending. */
void win_tell(struct win *w, int node, int tag, struct win_head head);
void win_tell_pending(struct win *w, int node, int tag, struct win_head head);
int win_node(const struct win *w, int rank);

/* --- epochs --- */

/* Checked: sends it, or keeps it. */
void active_keep(struct win *w, const struct access *a);
bool active_may(const struct win *w, int rank); /* is the rank the target of an active epoch? */
bool passive_may(const struct win *w, int rank);
void passive_send(struct win *w, const struct access *a);
void passive_begin(struct win *w);
void passive_end(struct win *w);
#endif
