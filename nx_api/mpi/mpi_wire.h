/* mpi_wire.h - a program's messages as messages of MPI: each is a head and a body, and all have one tag. The
 * receiving library takes every message in at once, so that no send waits for the program's receive.
 *
 * Only the program's own thread calls these functions (backend_node.h). */
#ifndef MPI_WIRE_H
#define MPI_WIRE_H
#include "backend_node.h"

/* Kinds of messages. All but DATA are between the libraries of two nodes. The comments give the head's `type`
 * and `value`. */
enum wire_kind {
    WIRE_DATA,  /* the program's; type; value: the sender's pid */
    WIRE_FLUSH, /* throw away what typesel `type` selects */
    WIRE_KILL,  /* end the process */
    WIRE_END,   /* the sender's process has ended. type: its status; value: its pid */
    WIRE_FILES  /* of shared_pointer.c. type: what; value: the pointer's number */
};

struct wire_head {
    int32_t kind, type, value, unused;
};

/* Begins and ends MPI. wire_begin gives the node its number and the count of nodes. */
void wire_begin(struct node *n, int *argc, char ***argv);
void wire_end(void);
/* Aborts all nodes at once. */
_Noreturn void wire_abort(int status);

/* To a node, or -1: all others. The bytes are copied. */
void wire_send(struct node *n, long node, struct wire_head head, const void *bytes, size_t len);
/* Takes in what has come, and frees what has been sent. True if anything has come. */
bool wire_progress(struct node *n);
/* Has MPI finished all sends? */
bool wire_is_empty(void);
#endif
