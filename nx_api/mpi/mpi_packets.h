/* mpi_packets.h - packets: messages of MPI of a limited size, in which short messages go, and the library's
 * own. They are so small that MPI sends them at once, without asking the receiver.
 *
 * A node has several receives of packets posted at all times, and looks at the oldest only: MPI fills them in
 * their order. So a message is matched once, and copied once, out of the packet into the program's buffer. */
#ifndef MPI_PACKETS_H
#define MPI_PACKETS_H
#include <mpi.h>
#include "nx_api/mpi/mpi_wire.h"

/* With MPI's own head a packet must not be larger than what its transports send at once: 4,096 bytes in
 * shared memory. */
enum { PACKET_ROOM = 4000 };

/* A message that has come in a packet, and is in it. */
struct packet {
    struct message message;
    struct packet *next; /* posted, or spare */
    MPI_Request request;
    struct wire_head head;
    char bytes[PACKET_ROOM];
};

void packets_begin(MPI_Comm comm);
void packets_end(void);

/* The next that has come, and from whom; NULL: none has. To be given back to packet_free. */
struct packet *packets_take(struct node *n, int *source);
void packet_free(struct packet *p);

/* Sends a head and its bytes, of which PACKET_ROOM is the most, to another node. Both are copied. */
void packet_send(struct node *n, long node, const struct wire_head *head, const void *bytes, size_t len);
/* Frees what MPI has sent. */
void packets_clear(void);
/* Has MPI sent all? */
bool packets_are_sent(void);
#endif
