/* mpi_wire.c - see mpi_wire.h. A message is given to the mailbox when its packet comes, so that all from
 * one sender keep their order; what waits for it waits until it is whole. */
#include "nx_api/mpi/mpi_wire.h"
#include <limits.h>
#include <mpi.h>
#include <stdlib.h>
#include <string.h>
#include "nx_api/mpi/bells.h"
#include "nx_api/mpi/idle.h"
#include "nx_api/mpi/mpi_bodies.h"
#include "nx_api/mpi/mpi_fragments.h"
#include "nx_api/mpi/mpi_mailbox.h"
#include "nx_api/mpi/mpi_packets.h"
#include "nx_api/mpi/order_record.h"
#include "nx_api/mpi/quiet.h"
#include "nx_api/mpi/run_summary.h"
#include "nx_api/mpi/shared_pointer.h"
#include "nx_api/mpi/states.h"

static MPI_Comm comm;

enum { TAKEN_AT_ONCE = 1000 };

/* --- begin and end --- */

bool wire_begin(struct node *n, int *argc, char ***argv)
{
    int given, rank, count;
    MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &given);
    MPI_Comm_dup(MPI_COMM_WORLD, &comm);
    MPI_Comm_rank(comm, &rank);
    MPI_Comm_size(comm, &count);
    n->id = rank;
    n->sys->count = (uint32_t)count;
    if (given < MPI_THREAD_FUNNELED)
        node_fail(n, "this MPI allows no second thread in a program (MPI_THREAD_FUNNELED)");
    packets_begin(comm);
    bodies_begin(comm);
    fragments_begin(n);
    bool rung = bells_begin(n);
    MPI_Barrier(comm); /* clocks begin together */
    idle_begin();
    return rung;
}

void wire_share(void *bytes, int count)
{
    MPI_Bcast(bytes, count, MPI_BYTE, 0, comm);
}

bool wire_all_are_here(bool here)
{
    static MPI_Request barrier;
    static bool begun;
    int all = 0;
    if (here && !begun) {
        MPI_Ibarrier(comm, &barrier);
        begun = true;
    }
    if (begun)
        MPI_Test(&barrier, &all, MPI_STATUS_IGNORE);
    return all;
}

void wire_end(void)
{
    idle_end();
    packets_end();
    MPI_Comm_free(&comm);
    MPI_Finalize();
}

_Noreturn void wire_abort(int status)
{
    MPI_Abort(comm, status);
    abort();
}

/* --- sending --- */

static void note_end(struct node *n, uint32_t node, const struct wire_head *head)
{
    struct mpi_end *e = &n->ends[node];
    e->ended = true, e->status = head->type, e->pid = head->value;
    e->order = ++n->ended;
}

/* A message between the libraries has come whole. */
static void act(struct node *n, const struct wire_head *head, int source, const void *bytes)
{
    switch ((enum wire_kind)head->kind) {
    case WIRE_DATA:
    case WIRE_FIRST:
    case WIRE_NEXT:
    case WIRE_OFFER:
    case WIRE_BODY:
        break; /* take_packet */
    case WIRE_FLUSH:
        mpi_mailbox_flush(n, head->type);
        break;
    case WIRE_KILL:
        n->killed = true;
        n->killed_alone = head->type;
        break;
    case WIRE_END:
        note_end(n, (uint32_t)source, head);
        break;
    case WIRE_FILES:
        shared_message(n, source, head->type, head->value, bytes);
        break;
    case WIRE_TOKEN:
        quiet_take(bytes);
        break;
    case WIRE_READY:
        body_wanted(n, head->value);
        break;
    case WIRE_ASK:
        states_tell(n);
        break;
    case WIRE_STATE:
        states_heard((uint32_t)source, bytes, (size_t)head->bytes);
        break;
    case WIRE_RECORD:
        record_part(bytes, (size_t)head->bytes);
        break;
    case WIRE_SUMMARY:
        summary_part((uint32_t)source, bytes, (size_t)head->bytes);
        break;
    }
}

static struct message from(const struct wire_head *head, int source)
{
    return (struct message){
        .type = head->type, .pid = head->value, .source = (uint32_t)source, .bytes = (size_t)head->bytes};
}

static struct message *new_message(struct node *n, const struct wire_head *head, int source)
{
    struct message *m = malloc(sizeof *m);
    if (!m)
        node_fail(n, "out of memory for messages");
    *m = from(head, source);
    return m;
}

/* A message of a node to itself has come at once. */
static void send_home(struct node *n, const struct wire_head *head, const void *bytes)
{
    size_t len = (size_t)head->bytes;
    if (head->kind != WIRE_DATA) {
        act(n, head, (int)n->id, bytes);
        return;
    }
    struct message *m = new_message(n, head, (int)n->id);
    m->block = malloc(len + 1);
    if (!m->block)
        node_fail(n, "no memory for a message of %zu bytes", len);
    if (len)
        memcpy(m->block, bytes, len);
    m->data = m->block;
    m->whole = true;
    RECORD_ORDER(arrival, m);
    mpi_mailbox_deliver(n, m);
}

static bool goes_in_packets(const struct wire_head *head, size_t len)
{
    return len <= PACKET_ROOM || (head->kind == WIRE_DATA && len <= FRAGMENTS_ROOM);
}

static void send_one(struct node *n, long node, const struct wire_head *head, const void *bytes, size_t len)
{
    if (node == n->id)
        send_home(n, head, bytes);
    else if (len <= PACKET_ROOM)
        packet_send(n, node, head, bytes, len);
    else if (goes_in_packets(head, len))
        fragments_send(n, node, *head, bytes, len);
    else
        body_send(n, node, *head, bytes, len);
}

void wire_send(struct node *n, long node, struct wire_head head, const void *bytes, size_t len)
{
    uint32_t count = n->sys->count;
    if (len > INT_MAX)
        node_fail(n, "a message of %zu bytes is too long for MPI", len);
    head.bytes = (int32_t)len;
    if (!wire_is_control(head.kind) && node != n->id)
        quiet_sent(node < 0 ? count - 1 : 1);
    if (!packets_are_sent())
        packets_clear();
    if (node >= 0)
        send_one(n, node, &head, bytes, len);
    else if (!goes_in_packets(&head, len))
        body_send(n, node, head, bytes, len);
    else
        for (uint32_t i = 1; i < count; i++)
            send_one(n, (n->id + i) % count, &head, bytes, len);
}

bool wire_is_empty(void)
{
    return packets_are_sent() && fragments_are_done() && bodies_are_done();
}

/* --- receiving --- */

static void deliver(struct node *n, struct message *m)
{
    RECORD_ORDER(arrival, m);
    mpi_mailbox_deliver(n, m);
}

/* A message that is in its packet. The packet is free again when the program has it; an unexpected message
 * moves to memory of its own. */
static void deliver_packet(struct node *n, struct packet *p, int source)
{
    quiet_received();
    p->message = from(&p->head, source);
    p->message.packet = p;
    p->message.data = p->bytes;
    p->message.whole = true;
    deliver(n, &p->message);
}

/* A message of which only the head has come: its body, too, or the offer of it. */
static void deliver_head(struct node *n, const struct packet *p, int source)
{
    struct message *m = new_message(n, &p->head, source);
    int32_t number;
    if (p->head.kind == WIRE_OFFER) {
        memcpy(&number, p->bytes, sizeof number);
        body_offered(source, number, m);
    } else {
        body_expect(n, &(struct body){.head = p->head, .source = source, .message = m}, NULL);
    }
    deliver(n, m);
}

/* True: a message is whole. */
static bool take_fragment(struct node *n, struct packet *p, int source)
{
    if (p->head.kind == WIRE_FIRST) {
        struct message *m = new_message(n, &p->head, source);
        fragments_expect(source, m);
        deliver(n, m);
    }
    struct message *m = fragments_keep(source, p);
    if (!m)
        return false;
    char *place = mpi_mailbox_place(m);
    m->block = place ? NULL : malloc(m->bytes);
    m->data = place ? place : m->block;
    if (!m->data)
        node_fail(n, "no memory for a message of %zu bytes", m->bytes);
    fragments_copy(source, place ? place : m->block);
    quiet_received();
    mpi_mailbox_whole(n, m);
    return true;
}

static void begin_body(struct node *n, const struct packet *p, int source)
{
    bool promised;
    struct message *m = body_announced(source, p->head.type, &promised);
    void *place = promised ? mpi_mailbox_place(m) : NULL;
    const struct wire_head head = {.kind = WIRE_DATA, .bytes = (int32_t)m->bytes};
    body_expect(n, &(struct body){.head = head, .source = source, .message = m, .promised = promised}, place);
}

/* Does what a packet says. True: it may end a wait. */
static bool take_packet(struct node *n, struct packet *p, int source)
{
    const int32_t kind = p->head.kind;
    if (__builtin_expect(kind == WIRE_DATA && p->head.bytes <= PACKET_ROOM, 1)) {
        deliver_packet(n, p, source);
        return true;
    }
    if (kind == WIRE_FIRST || kind == WIRE_NEXT)
        return take_fragment(n, p, source);
    if (kind == WIRE_DATA || kind == WIRE_OFFER) {
        deliver_head(n, p, source);
    } else if (kind == WIRE_BODY) {
        begin_body(n, p, source);
    } else if (p->head.bytes > PACKET_ROOM) {
        body_expect(n, &(struct body){.head = p->head, .source = source}, NULL);
    } else {
        if (!wire_is_control(kind))
            quiet_received();
        act(n, &p->head, source, p->bytes);
    }
    packet_free(p);
    return !wire_is_control(kind);
}

static bool take_body(struct node *n, struct body *b)
{
    const bool tells = !wire_is_control(b->head.kind);
    if (tells)
        quiet_received();
    if (b->message) {
        b->message->data = b->bytes;
        b->message->block = b->placed ? NULL : b->bytes;
        mpi_mailbox_whole(n, b->message);
    } else {
        act(n, &b->head, b->source, b->bytes);
        free(b->bytes);
    }
    free(b);
    return tells;
}

static bool take_all(struct node *n)
{
    bool tells = false;
    struct packet *p;
    struct body *b;
    int source;
    for (int i = 0; i < TAKEN_AT_ONCE && (p = packets_take(n, &source)); i++)
        tells |= take_packet(n, p, source);
    packets_clear();
    bodies_clear();
    bodies_answer(n);
    while ((b = bodies_take()))
        tells |= take_body(n, b);
    return tells;
}

bool wire_progress(struct node *n)
{
    bool tells = take_all(n);
    while (bodies_are_promised()) {
        idle_pause();
        tells |= take_all(n);
    }
    return tells;
}

void wire_free(struct message *m)
{
    if (m->packet) {
        packet_free(m->packet);
        return;
    }
    free(m->block);
    free(m);
}

struct message *wire_keep(struct node *n, struct message *m)
{
    if (m->data == m->block)
        return m;
    struct message *own = malloc(sizeof *own);
    void *block = malloc(m->bytes + 1);
    if (!own || !block)
        node_fail(n, "out of memory for messages");
    if (m->bytes)
        memcpy(block, m->data, m->bytes);
    *own = *m;
    own->packet = NULL;
    own->data = own->block = block;
    wire_free(m);
    return own;
}
