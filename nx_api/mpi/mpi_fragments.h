/* mpi_fragments.h - messages of a few packets: too long for one, and too short for an offer (mpi_bodies.h),
 * whose trips would take longer than the copying. The sender's packets go one behind the other, at once:
 *
 *     FIRST   the message's head, and its first PACKET_ROOM bytes
 *     NEXT    the following ones, as often as it takes
 *
 * A message takes its place among those that have come with its first fragment. Its packets stay as they are
 * until the last has come: only then are the bytes copied, into the buffer of the receive, or into memory if
 * there is none yet. */
#ifndef MPI_FRAGMENTS_H
#define MPI_FRAGMENTS_H
#include "nx_api/mpi/mpi_wire.h"

struct packet; /* mpi_packets.h */

/* The longest message that goes in fragments. */
enum { FRAGMENTS_ROOM = 20000 };

void fragments_begin(struct node *n);

/* A message to another node, longer than PACKET_ROOM. The bytes have been copied when it returns. */
void fragments_send(struct node *n, long node, struct wire_head head, const void *bytes, size_t len);

/* A FIRST has come; m is its message. */
void fragments_expect(int source, struct message *m);
/* Keeps a packet, FIRST or NEXT, of the message that comes from there. The message, if it is whole now; else
 * NULL. */
struct message *fragments_keep(int source, struct packet *p);
/* The bytes of a message that is whole, as long as it is, to `place`. Frees its packets. */
void fragments_copy(int source, char *place);

/* Has all come whole? */
bool fragments_are_done(void);
#endif
