/* mpi_fragments.c - see mpi_fragments.h. Packets of one sender come in their order, and a send does nothing
 * else before its last packet: so all NEXT behind a FIRST are its own. */
#include "nx_api/mpi/mpi_fragments.h"
#include <stdlib.h>
#include <string.h>
#include "nx_api/mpi/mpi_packets.h"

/* What comes from a node. */
struct assembly {
    struct message *message; /* NULL: none */
    struct packet *first, **end;
    size_t missing; /* bytes */
};

static struct assembly *assemblies; /* by sender */
static uint32_t under_way;

void fragments_begin(struct node *n)
{
    assemblies = calloc(n->sys->count, sizeof *assemblies);
    if (!assemblies)
        node_fail(n, "out of memory");
}

static size_t length_of(size_t left)
{
    return left < PACKET_ROOM ? left : PACKET_ROOM;
}

void fragments_send(struct node *n, long node, struct wire_head head, const void *bytes, size_t len)
{
    const char *from = bytes;
    head.kind = WIRE_FIRST;
    packet_send(n, node, &head, from, PACKET_ROOM);
    for (size_t at = PACKET_ROOM; at < len; at += PACKET_ROOM) {
        const size_t length = length_of(len - at);
        packet_send(n, node, &(struct wire_head){.kind = WIRE_NEXT, .bytes = (int32_t)length}, from + at,
                    length);
    }
}

void fragments_expect(int source, struct message *m)
{
    struct assembly *a = &assemblies[source];
    *a = (struct assembly){.message = m, .end = &a->first, .missing = m->bytes};
    under_way++;
}

struct message *fragments_keep(int source, struct packet *p)
{
    struct assembly *a = &assemblies[source];
    p->next = NULL;
    *a->end = p;
    a->end = &p->next;
    a->missing -= length_of(a->missing);
    return a->missing ? NULL : a->message;
}

void fragments_copy(int source, char *place)
{
    struct assembly *a = &assemblies[source];
    size_t left = a->message->bytes;
    for (struct packet *p = a->first, *next; p; p = next) {
        const size_t length = length_of(left);
        next = p->next;
        memcpy(place, p->bytes, length);
        place += length, left -= length;
        packet_free(p);
    }
    a->message = NULL;
    under_way--;
}

bool fragments_are_done(void)
{
    return !under_way;
}
