/* mpi_wire.h - a program's messages as messages of MPI. Short ones go in a packet (mpi_packets.h), or in a
 * few (mpi_fragments.h), at once; long ones are announced by a packet, and their bytes follow (mpi_bodies.h).
 * The receiving library takes all in, so that no send waits for the program's receive.
 *
 * Only the program's own thread calls these functions (backend_node.h). */
#ifndef MPI_WIRE_H
#define MPI_WIRE_H
#include "backend_node.h"

/* Kinds of messages. All but DATA are between the libraries of two nodes. The comments give the head's
 * `type` and `value`. Those from TOKEN on change nothing that a program waits for: they are not counted
 * (quiet.h), and wire_progress does not tell of them. */
enum wire_kind {
    WIRE_DATA,  /* the program's; type; value: the sender's pid */
    WIRE_FIRST, /* the same, of which a part follows in WIRE_NEXT */
    WIRE_NEXT,  /* of mpi_fragments.c */
    WIRE_OFFER, /* WIRE_DATA, of which the bytes follow a WIRE_BODY; in the packet: the offer's number */
    WIRE_FLUSH, /* throw away what typesel `type` selects */
    WIRE_KILL,  /* end the process. type: 1 if it alone is to end */
    WIRE_END,   /* the sender's process has ended. type: its status; value: its pid */
    WIRE_FILES, /* of shared_pointer.c. type: what; value: the pointer's number */
    WIRE_TOKEN, /* of quiet.c */
    WIRE_READY, /* to the sender of offer `value`: this node is receiving it */
    WIRE_BODY, /* the bytes of the sender's last offer come now. type: 1 if out of its program's own buffer */
    WIRE_ASK,  /* what does the node wait for? */
    WIRE_STATE,  /* the answer, of states.c */
    WIRE_RECORD, /* a part of a record, of order_record.c */
    WIRE_SUMMARY /* a part of run_summary.c */
};

struct wire_head {
    int32_t kind, type, value, bytes; /* bytes: of the message, behind the head; wire_send sets it */
};

/* Messages that change what a program waits for are counted. */
static inline bool wire_is_control(int32_t kind)
{
    return kind >= WIRE_TOKEN;
}

/* Begins and ends MPI. wire_begin gives the node its number and the count of nodes. True: all nodes ring
 * when they send (bells.h). */
bool wire_begin(struct node *n, int *argc, char ***argv);
void wire_end(void);
/* All nodes get node 0's bytes. Before messages are sent. */
void wire_share(void *bytes, int count);
/* Aborts all nodes at once. */
_Noreturn void wire_abort(int status);

/* To a node, or -1: all others. The bytes have been copied, or received, when it returns. */
void wire_send(struct node *n, long node, struct wire_head head, const void *bytes, size_t len);
/* Takes in what has come, and frees what has been sent. True if anything has come that may end a wait. */
bool wire_progress(struct node *n);
/* Has MPI finished all sends, and has all come whole that has been announced? */
bool wire_is_empty(void);
/* Frees a message. Moves one that no receive asks for to memory of its own: out of its packet, or out of the
 * buffer of a receive that has been withdrawn. */
void wire_free(struct message *m);
struct message *wire_keep(struct node *n, struct message *m);
/* For the end: has this been called with `here` on all nodes? To be called again until it is true. */
bool wire_all_are_here(bool here);
#endif
