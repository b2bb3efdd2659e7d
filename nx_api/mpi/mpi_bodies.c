/* mpi_bodies.c - see mpi_bodies.h. */
#include "nx_api/mpi/mpi_bodies.h"
#include <mpi.h>
#include <stdlib.h>
#include <string.h>
#include "nx_api/mpi/bells.h"
#include "nx_api/mpi/idle.h"
#include "nx_api/mpi/mpi_mailbox.h"
#include "nx_api/mpi/mpi_node.h"
#include "nx_api/mpi/mpi_packets.h"

enum { TAG = 2, PART = 1 << 16, TESTED_AT_ONCE = 8 };

/* A sender looks for READY for ANSWER_S, in which a node that waits answers if it is near, and as long as a
 * copy of the bytes may take. Its receiver leaves an offer without a receive unanswered for half of the
 * latter. */
static const double ANSWER_S = 1.5e-6;
static const double COPIED_BYTES_PER_S = 10e9;
static const double LEFT_BYTES_PER_S = 2 * COPIED_BYTES_PER_S;

/* A copy of a body, on its way to one node or to several. */
struct copy {
    uint32_t flights;
    char bytes[];
};

struct flight {
    struct flight *next;
    struct copy *copy;
    MPI_Request request;
};

/* This node's last offer. */
static struct {
    int32_t number;
    bool open;    /* neither copied nor wanted yet */
    bool sending; /* the program is in its csend */
    long node;
    const void *bytes;
    size_t len;
    MPI_Request request; /* if it was wanted */
} offer;

static MPI_Comm comm;
static struct flight *flights, **flights_end = &flights;
static struct body *bodies, **bodies_end = &bodies;
static uint32_t promises;

/* A sender's last offer. */
struct offered {
    struct offered *next; /* not answered yet */
    struct message *m;
    int source;
    int32_t number;
    double since;
    bool waits, promised; /* not answered; READY has been said */
};
static struct offered *offered, *unanswered; /* by sender; a list */

void bodies_begin(MPI_Comm on)
{
    comm = on;
    offered = calloc(node_self()->sys->count, sizeof *offered);
    if (!offered)
        node_fail(node_self(), "out of memory");
}

static bool is_done(MPI_Request *request)
{
    int done;
    MPI_Test(request, &done, MPI_STATUS_IGNORE);
    return done;
}

/* --- sending --- */

static bool free_if_sent(struct flight *f)
{
    if (!is_done(&f->request))
        return false;
    if (--f->copy->flights == 0)
        free(f->copy);
    free(f);
    return true;
}

static void append_flight(struct flight *f)
{
    f->next = NULL;
    *flights_end = f;
    flights_end = &f->next;
}

void bodies_clear(void)
{
    for (int i = 0; i < TESTED_AT_ONCE && flights; i++) {
        struct flight *f = flights;
        flights = f->next;
        if (!flights)
            flights_end = &flights;
        if (!free_if_sent(f))
            append_flight(f);
    }
}

static struct copy *new_copy(struct node *n, size_t len)
{
    struct copy *c = malloc(sizeof *c + len);
    if (!c)
        node_fail(n, "no memory for a message of %zu bytes", len);
    c->flights = 0;
    return c;
}

static void launch(struct node *n, long node, struct copy *c, size_t len)
{
    struct flight *f = malloc(sizeof *f);
    if (!f)
        node_fail(n, "out of memory for messages that are on their way");
    f->copy = c;
    c->flights++;
    MPI_Isend(c->bytes, (int)len, MPI_BYTE, (int)node, TAG, comm, &f->request);
    bell_ring(node);
    append_flight(f);
}

static void send_copied(struct node *n, long node, const struct wire_head *head, const void *bytes,
                        size_t len)
{
    uint32_t count = n->sys->count;
    if (count == 1)
        return; /* there are no others: nobody would free the copy */
    struct copy *c = new_copy(n, len);
    memcpy(c->bytes, bytes, len);
    for (uint32_t i = 1; i < count; i++) {
        long to = (n->id + i) % count;
        if (node >= 0 && to != node)
            continue;
        packet_send(n, to, head, NULL, 0);
        launch(n, to, c, len);
    }
}

static void announce(struct node *n, bool directly)
{
    packet_send(n, offer.node, &(struct wire_head){.kind = WIRE_BODY, .type = directly}, NULL, 0);
}

void body_wanted(struct node *n, int32_t number)
{
    if (!offer.open || number != offer.number)
        return;
    bodies_answer(n); /* before MPI moves the bytes, and does nothing else */
    offer.open = false;
    announce(n, true);
    MPI_Isend(offer.bytes, (int)offer.len, MPI_BYTE, (int)offer.node, TAG, comm, &offer.request);
    bell_ring(offer.node);
}

/* Looks for the answer; for so long only that the send takes about twice a copy's time at most. */
static void await_answer(struct node *n)
{
    const double until = mpi_seconds() + ANSWER_S + (double)offer.len / COPIED_BYTES_PER_S;
    for (wire_progress(n); offer.open && mpi_seconds() < until; wire_progress(n))
        idle_pause();
}

/* Copies the bytes, but stops when the answer comes: then there is no copy. NULL: so it is. */
static struct copy *copy_while_open(struct node *n)
{
    struct copy *c = new_copy(n, offer.len);
    const char *bytes = offer.bytes;
    for (size_t at = 0; offer.open && at < offer.len; at += PART) {
        memcpy(c->bytes + at, bytes + at, offer.len - at < PART ? offer.len - at : PART);
        wire_progress(n);
    }
    if (offer.open)
        return c;
    free(c);
    return NULL;
}

static void send_offered(struct node *n, long node, struct wire_head head, const void *bytes, size_t len)
{
    head.kind = WIRE_OFFER;
    offer.open = offer.sending = true, offer.number++, offer.node = node, offer.bytes = bytes,
    offer.len = len;
    packet_send(n, node, &head, &offer.number, sizeof offer.number);
    await_answer(n);
    struct copy *c = offer.open ? copy_while_open(n) : NULL;
    if (c) {
        offer.open = false;
        announce(n, false);
        launch(n, node, c, len);
    } else {
        for (; !is_done(&offer.request); wire_progress(n))
            idle_pause();
    }
    offer.sending = false;
}

void body_send(struct node *n, long node, struct wire_head head, const void *bytes, size_t len)
{
    if (node >= 0 && head.kind == WIRE_DATA)
        send_offered(n, node, head, bytes, len);
    else
        send_copied(n, node, &head, bytes, len);
}

/* --- receiving --- */

void body_offered(int source, int32_t number, struct message *m)
{
    offered[source] = (struct offered){unanswered, m, source, number, mpi_seconds(), true, false};
    unanswered = &offered[source];
}

static void forget(struct offered *o)
{
    struct offered **link = &unanswered;
    while (*link != o)
        link = &(*link)->next;
    *link = o->next;
    o->waits = false;
}

/* A program that has an offer of its own open makes no receive before that is answered. One that has made the
 * receive, but does not wait, may be about to send: then both messages move at once. */
static bool is_time(const struct node *n, const struct offered *o)
{
    bool stays = offer.open || o->m->lost, waits = n->ready || offer.sending;
    return stays || (waits && mpi_mailbox_place(o->m)) ||
           mpi_seconds() - o->since > (double)o->m->bytes / LEFT_BYTES_PER_S;
}

void bodies_answer(struct node *n)
{
    for (struct offered *o = unanswered, *next; o; o = next) {
        next = o->next;
        if (!is_time(n, o))
            continue;
        forget(o);
        o->promised = true;
        promises++;
        packet_send(n, o->source, &(struct wire_head){.kind = WIRE_READY, .value = o->number}, NULL, 0);
    }
}

struct message *body_announced(int source, bool directly, bool *promised)
{
    struct offered *o = &offered[source];
    if (o->waits)
        forget(o);
    promises -= o->promised && !directly;
    *promised = directly;
    return o->m;
}

void body_expect(struct node *n, const struct body *what, void *place)
{
    struct body *b = malloc(sizeof *b);
    void *bytes = place ? place : malloc((size_t)what->head.bytes);
    if (!b || !bytes)
        node_fail(n, "no memory for a message of %d bytes from node %d", what->head.bytes, what->source);
    *b = *what;
    b->bytes = bytes, b->placed = place, b->next = NULL;
    MPI_Irecv(bytes, b->head.bytes, MPI_BYTE, b->source, TAG, comm, &b->request);
    *bodies_end = b;
    bodies_end = &b->next;
}

struct body *bodies_take(void)
{
    for (struct body **link = &bodies, *b; (b = *link); link = &b->next) {
        if (!is_done(&b->request))
            continue;
        *link = b->next;
        if (bodies_end == &b->next)
            bodies_end = link;
        promises -= b->promised;
        return b;
    }
    return NULL;
}

bool bodies_are_promised(void)
{
    return promises;
}

bool bodies_are_done(void)
{
    return !flights && !bodies && !promises && !unanswered;
}
