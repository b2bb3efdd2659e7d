/* mpi_wire.h - a program's messages as messages of MPI: each is a head and a body, and all have one tag. The
 * receiving library takes every message in at once, so that no send waits for the program's receive.
 *
 * Only the program's own thread calls these functions (backend_node.h). */
#ifndef MPI_WIRE_H
#define MPI_WIRE_H
#include "backend_node.h"

/* Kinds of messages. All but DATA are between the libraries of two nodes. The comments give the head's
 * `type` and `value`. Those from TOKEN on change nothing that a program waits for: they are not counted
 * (quiet.h), and wire_progress does not tell of them. */
enum wire_kind {
    WIRE_DATA,   /* the program's; type; value: the sender's pid */
    WIRE_FLUSH,  /* throw away what typesel `type` selects */
    WIRE_KILL,   /* end the process. type: 1 if it alone is to end */
    WIRE_END,    /* the sender's process has ended. type: its status; value: its pid */
    WIRE_FILES,  /* of shared_pointer.c. type: what; value: the pointer's number */
    WIRE_TOKEN,  /* of quiet.c */
    WIRE_ASK,    /* what does the node wait for? */
    WIRE_STATE,  /* the answer, of states.c */
    WIRE_RECORD, /* a part of a record, of order_record.c */
    WIRE_SUMMARY /* a part of run_summary.c */
};

struct wire_head {
    int32_t kind, type, value, unused;
};

/* Begins and ends MPI. wire_begin gives the node its number and the count of nodes. */
void wire_begin(struct node *n, int *argc, char ***argv);
void wire_end(void);
/* All nodes get node 0's bytes. Before messages are sent. */
void wire_share(void *bytes, int count);
/* Aborts all nodes at once. */
_Noreturn void wire_abort(int status);

/* To a node, or -1: all others. The bytes are copied. */
void wire_send(struct node *n, long node, struct wire_head head, const void *bytes, size_t len);
/* Takes in what has come, and frees what has been sent. True if anything has come that may end a wait. */
bool wire_progress(struct node *n);
/* Has MPI finished all sends? */
bool wire_is_empty(void);
/* For the end: has this been called with `here` on all nodes? To be called again until it is true. */
bool wire_all_are_here(bool here);
#endif
