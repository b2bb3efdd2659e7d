/* wire.h - the messages of a program as messages of MPI: a head and the body in one, all with one tag. The receiver always
 * takes them in, whatever the program does with them, so that no send ever waits for a receive.
 *
 * Only the program's own thread calls these, outside of the C library (node.h). */
#ifndef MPI_WIRE_H
#define MPI_WIRE_H
#include "backend_node.h"

/* What a message is. All but DATA are between the libraries of two nodes; `type` and `value` of the head as said. */
enum wire_kind {
    WIRE_DATA,  /* of the program: type, value: the sender's pid */
    WIRE_FLUSH, /* throw away what typesel `type` selects */
    WIRE_KILL,  /* end */
    WIRE_END,   /* my process has ended: type: its status, value: its pid. From now on it only answers */
    WIRE_FILES  /* of shared.c: type: what, value: which pointer */
};

struct wire_head {
    int32_t kind, type, value, unused;
};

/* Begins and ends MPI. wire_begin gives the node its number and the count of nodes. */
void wire_begin(struct node *n, int *argc, char ***argv);
void wire_end(void);
/* Ends all nodes the hard way: they get no word of it. */
_Noreturn void wire_abort(int status);

/* To a node, or -1: all others. The bytes are copied. */
void wire_send(struct node *n, long node, struct wire_head head, const void *bytes, size_t len);
/* Takes in what has come, and frees what has gone. True if anything has come. */
bool wire_progress(struct node *n);
/* Has everything gone that was sent? */
bool wire_is_empty(void);
#endif
