/* mpi_packets.c - see mpi_packets.h. Receives are persistent requests: each belongs to a packet, and is
 * started again when the packet is free.
 *
 * Nearly always MPI has copied a packet away when MPI_Isend returns: then the flight, which the packet is
 * sent from, serves for the next. Flights that take longer are tested a few at a time, in rotation. */
#include "nx_api/mpi/mpi_packets.h"
#include <mpi.h>
#include <stdlib.h>
#include <string.h>
#include "nx_api/mpi/bells.h"

enum { TAG = 1, POSTED_AT_LEAST = 8, TESTED_AT_ONCE = 8 };

struct flight {
    struct flight *next;
    MPI_Request request;
    struct wire_head head; /* followed by the bytes */
};

static MPI_Comm comm;
static struct packet *posted, **posted_end = &posted;
static unsigned posted_count;
static struct flight *flights, **flights_end = &flights, *spare;

/* --- receiving --- */

static void post(struct packet *p)
{
    MPI_Start(&p->request);
    p->next = NULL;
    *posted_end = p;
    posted_end = &p->next;
    posted_count++;
}

static void post_new(struct node *n)
{
    struct packet *p = malloc(sizeof *p);
    if (!p)
        node_fail(n, "out of memory for messages");
    MPI_Recv_init(&p->head, (int)(sizeof p->head + PACKET_ROOM), MPI_BYTE, MPI_ANY_SOURCE, TAG, comm,
                  &p->request);
    post(p);
}

static struct packet *unpost(void)
{
    struct packet *p = posted;
    posted = p->next;
    if (!posted)
        posted_end = &posted;
    posted_count--;
    return p;
}

void packets_begin(MPI_Comm on)
{
    comm = on;
    while (posted_count < POSTED_AT_LEAST)
        post_new(node_self());
}

void packets_end(void)
{
    while (posted) {
        struct packet *p = unpost();
        MPI_Cancel(&p->request);
        MPI_Wait(&p->request, MPI_STATUS_IGNORE);
        MPI_Request_free(&p->request);
        free(p);
    }
}

struct packet *packets_take(struct node *n, int *source)
{
    int done;
    MPI_Status status;
    MPI_Test(&posted->request, &done, &status);
    if (!done)
        return NULL;
    struct packet *p = unpost();
    if (posted_count < POSTED_AT_LEAST / 2)
        post_new(n);
    *source = status.MPI_SOURCE;
    return p;
}

void packet_free(struct packet *p)
{
    post(p);
}

/* --- sending --- */

static bool is_sent(struct flight *f)
{
    int done;
    MPI_Test(&f->request, &done, MPI_STATUS_IGNORE);
    return done;
}

static void append_flight(struct flight *f)
{
    f->next = NULL;
    *flights_end = f;
    flights_end = &f->next;
}

void packets_clear(void)
{
    for (int i = 0; i < TESTED_AT_ONCE && flights; i++) {
        struct flight *f = flights;
        flights = f->next;
        if (!flights)
            flights_end = &flights;
        if (is_sent(f))
            free(f);
        else
            append_flight(f);
    }
}

bool packets_are_sent(void)
{
    return !flights;
}

/* The spare one has room for any packet. While flights take long, each has memory of its size. */
static struct flight *new_flight(struct node *n, size_t len)
{
    struct flight *f = spare;
    spare = NULL;
    if (f && flights) {
        spare = f;
        f = malloc(sizeof *f + len);
    } else if (!f) {
        f = malloc(sizeof *f + PACKET_ROOM);
    }
    if (!f)
        node_fail(n, "out of memory for messages that are on their way");
    return f;
}

void packet_send(struct node *n, long node, const struct wire_head *head, const void *bytes, size_t len)
{
    struct flight *f = new_flight(n, len);
    bool spares = !spare;
    f->head = *head;
    if (len)
        memcpy(&f->head + 1, bytes, len);
    MPI_Isend(&f->head, (int)(sizeof f->head + len), MPI_BYTE, (int)node, TAG, comm, &f->request);
    bell_ring(node);
    if (!is_sent(f))
        append_flight(f);
    else if (spares)
        spare = f;
    else
        free(f);
}
