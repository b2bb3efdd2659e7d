/* mpi_bodies.h - the bytes of messages that are too long for packets. A message to one node is offered:
 *
 *     sender                                         receiver
 *     csend   OFFER  ------------------------------> the message takes its place among those that have come
 *             looks for READY for a time;
 *             then copies the bytes, a  <----------- READY, when there is a receive for it, and the program
 *             part at a time, and looks              waits or sends; without a receive after a shorter time
 *      READY has come in time:
 *             BODY, out of the program's buffer ---> receives them at once: in the buffer of the receive,
 *             goes on when MPI has sent them         or in memory if there is none yet
 *      all has been copied first:
 *             BODY, out of the copy ---------------> receives them in memory
 *             goes on at once
 *
 * So a send waits for no receive: if the receiver computes, in 1 ms or for ever, the bytes are copied. A
 * receiver that has said READY, and a sender to whom it has been said, do nothing but receive and send until
 * that offer is settled; each goes on with all other offers meanwhile, so that no circle of nodes stands
 * still.
 *
 * The bodies of one sender come in the order of their announcements. A message to all others is not
 * offered, but copied once: the WIRE_DATA itself announces its body. */
#ifndef MPI_BODIES_H
#define MPI_BODIES_H
#include <mpi.h>
#include "nx_api/mpi/mpi_wire.h"

void bodies_begin(MPI_Comm comm);

/* Sends to one node, or to all others. */
void body_send(struct node *n, long node, struct wire_head head, const void *bytes, size_t len);
/* READY has come for an offer of this node. */
void body_wanted(struct node *n, int32_t number);

/* A body that has come whole. */
struct body {
    struct body *next;
    MPI_Request request;
    struct wire_head head;
    int source;
    struct message *message; /* whose body it is; NULL: the library's own */
    void *bytes;
    bool placed;   /* in the program's buffer; else malloc'd */
    bool promised; /* READY has been said */
};

/* The offer of a message has come. */
void body_offered(int source, int32_t number, struct message *m);
/* Says READY for the offers for which it is time. */
void bodies_answer(struct node *n);
/* WIRE_BODY has come: the message of the sender's last offer. *promised: to be given to body_expect. */
struct message *body_announced(int source, bool directly, bool *promised);
/* Receives a body that has been announced: in `place`, or if that is NULL in memory. */
void body_expect(struct node *n, const struct body *what, void *place);

/* The next that has come whole, to be freed; NULL: none has. */
struct body *bodies_take(void);
/* Frees what MPI has sent. */
void bodies_clear(void);
/* Has READY been said for an offer that is not settled? */
bool bodies_are_promised(void);
/* Have all been sent, and come? */
bool bodies_are_done(void);
#endif
