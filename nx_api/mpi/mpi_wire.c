/* mpi_wire.c - see mpi_wire.h.
 *
 * A packet is a copy of a message to be sent; a flight is a packet on its way to one node. Flights are tested
 * a few at a time, in rotation: the end of a flight only frees memory.
 *
 * A message that comes is matched by MPI_Improbe, and received at once into memory of its size. The bytes of
 * a long one may come late, while its sender computes; meanwhile messages of other senders are taken in, but
 * none of the same sender. */
#include "nx_api/mpi/mpi_wire.h"
#include <limits.h>
#include <mpi.h>
#include <stdlib.h>
#include <string.h>
#include "nx_api/mpi/mpi_mailbox.h"
#include "nx_api/mpi/quiet.h"
#include "nx_api/mpi/order_record.h"
#include "nx_api/mpi/run_summary.h"
#include "nx_api/mpi/shared_pointer.h"
#include "nx_api/mpi/states.h"

struct packet {
    uint32_t flights;
    struct wire_head head; /* followed by the bytes */
};

struct flight {
    struct flight *next;
    struct packet *packet;
    MPI_Request request;
};

struct arrival {
    struct arrival *next;
    MPI_Request request;
    int source, bytes; /* bytes: head and body */
    struct wire_head *head;
};

static MPI_Comm comm;
static struct flight *flights, **flights_end = &flights;
static struct arrival *arrivals, **arrivals_end = &arrivals;

enum { TAG = 1, TESTED_AT_ONCE = 8, TAKEN_AT_ONCE = 1000 };

/* --- begin and end --- */

void wire_begin(struct node *n, int *argc, char ***argv)
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
    MPI_Barrier(comm); /* clocks begin together */
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
    MPI_Comm_free(&comm);
    MPI_Finalize();
}

_Noreturn void wire_abort(int status)
{
    MPI_Abort(comm, status);
    abort();
}

/* --- sending --- */

static bool is_control(int32_t kind)
{
    return kind >= WIRE_TOKEN;
}

static bool free_if_sent(struct flight *f)
{
    int done;
    MPI_Test(&f->request, &done, MPI_STATUS_IGNORE);
    if (!done)
        return false;
    if (--f->packet->flights == 0)
        free(f->packet);
    free(f);
    return true;
}

static void append_flight(struct flight *f)
{
    f->next = NULL;
    *flights_end = f;
    flights_end = &f->next;
}

static void test_flights(void)
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

bool wire_is_empty(void)
{
    return !flights;
}

static void launch(struct node *n, long node, struct packet *p, size_t bytes)
{
    struct flight *f = malloc(sizeof *f);
    if (!f)
        node_fail(n, "out of memory for messages that are on their way");
    f->packet = p;
    if (!is_control(p->head.kind))
        quiet_sent();
    MPI_Isend(&p->head, (int)bytes, MPI_BYTE, (int)node, TAG, comm, &f->request);
    if (!free_if_sent(f))
        append_flight(f);
}

static void act(struct node *n, struct arrival *a);

/* A message of a node to itself has come at once. */
static void send_home(struct node *n, const struct packet *p, size_t bytes)
{
    struct wire_head *copy = malloc(bytes);
    if (!copy)
        node_fail(n, "out of memory for messages");
    memcpy(copy, &p->head, bytes);
    act(n, &(struct arrival){.source = (int)n->id, .bytes = (int)bytes, .head = copy});
}

void wire_send(struct node *n, long node, struct wire_head head, const void *bytes, size_t len)
{
    uint32_t count = n->sys->count;
    size_t whole = sizeof head + len;
    if (node < 0 && count == 1)
        return;
    struct packet *p = whole <= INT_MAX ? malloc(offsetof(struct packet, head) + whole) : NULL;
    if (!p)
        node_fail(n, "no memory for a message of %zu bytes", len);
    p->flights = node < 0 ? count : 2; /* one more than flights, until all have been launched */
    p->head = head;
    if (len)
        memcpy(&p->head + 1, bytes, len);
    if (node == n->id) {
        p->flights--;
        send_home(n, p, whole);
    } else if (node >= 0) {
        launch(n, node, p, whole);
    }
    for (uint32_t i = 1; node < 0 && i < count; i++)
        launch(n, (n->id + i) % count, p, whole);
    if (--p->flights == 0)
        free(p);
}

/* --- receiving --- */

static void note_end(struct node *n, uint32_t node, const struct wire_head *head)
{
    struct mpi_end *e = &n->ends[node];
    e->ended = true, e->status = head->type, e->pid = head->value;
    e->order = ++n->ended;
}

static void deliver(struct node *n, struct arrival *a)
{
    struct message *m = malloc(sizeof *m);
    if (!m)
        node_fail(n, "out of memory for messages");
    *m = (struct message){.type = a->head->type,
                          .pid = a->head->value,
                          .source = (uint32_t)a->source,
                          .bytes = (size_t)a->bytes - sizeof *a->head,
                          .data = (const char *)(a->head + 1),
                          .block = a->head};
    a->head = NULL;
    RECORD_ORDER(arrival, m);
    mpi_mailbox_deliver(n, m);
}

/* Handles a message that has come whole. */
static void act(struct node *n, struct arrival *a)
{
    const struct wire_head *head = a->head;
    if (!is_control(head->kind) && a->source != n->id)
        quiet_received();
    switch ((enum wire_kind)head->kind) {
    case WIRE_DATA:
        deliver(n, a);
        break;
    case WIRE_FLUSH:
        mpi_mailbox_flush(n, head->type);
        break;
    case WIRE_KILL:
        n->killed = true;
        n->killed_alone = head->type;
        break;
    case WIRE_END:
        note_end(n, (uint32_t)a->source, head);
        break;
    case WIRE_FILES:
        shared_message(n, a->source, head->type, head->value, head + 1);
        break;
    case WIRE_TOKEN:
        quiet_take(head + 1);
        break;
    case WIRE_ASK:
        states_tell(n);
        break;
    case WIRE_STATE:
        states_heard((uint32_t)a->source, head + 1, (size_t)a->bytes - sizeof *head);
        break;
    case WIRE_RECORD:
        record_part(head + 1, (size_t)a->bytes - sizeof *head);
        break;
    case WIRE_SUMMARY:
        summary_part((uint32_t)a->source, head + 1, (size_t)a->bytes - sizeof *head);
        break;
    }
    free(a->head);
}

static bool has_arrived(struct arrival *a)
{
    int done;
    MPI_Test(&a->request, &done, MPI_STATUS_IGNORE);
    return done;
}

/* Takes the first message that MPI has, without waiting for its bytes. False: there is none. *tells: it
 * may end a wait. */
static bool take_one(struct node *n, bool *tells)
{
    int any;
    MPI_Message message;
    MPI_Status status;
    MPI_Improbe(MPI_ANY_SOURCE, TAG, comm, &any, &message, &status);
    if (!any)
        return false;
    struct arrival *a = malloc(sizeof *a);
    MPI_Get_count(&status, MPI_BYTE, &a->bytes);
    a->source = status.MPI_SOURCE;
    a->head = malloc((size_t)a->bytes);
    if (!a->head)
        node_fail(n, "no memory for a message of %d bytes from node %d", a->bytes, a->source);
    MPI_Imrecv(a->head, a->bytes, MPI_BYTE, &message, &a->request);
    if (!arrivals && has_arrived(a)) {
        *tells |= !is_control(a->head->kind);
        act(n, a);
        free(a);
        return true;
    }
    *tells = true;
    a->next = NULL;
    *arrivals_end = a;
    arrivals_end = &a->next;
    return true;
}

static bool is_passing(const struct arrival *a)
{
    for (const struct arrival *b = arrivals; b != a; b = b->next)
        if (b->source == a->source)
            return true;
    return false;
}

static bool test_arrivals(struct node *n)
{
    bool tells = false;
    struct arrival **link = &arrivals;
    while (*link) {
        struct arrival *a = *link;
        if (is_passing(a) || !has_arrived(a)) {
            link = &a->next;
            continue;
        }
        *link = a->next;
        if (arrivals_end == &a->next)
            arrivals_end = link;
        tells |= !is_control(a->head->kind);
        act(n, a);
        free(a);
    }
    return tells;
}

bool wire_progress(struct node *n)
{
    bool tells = false;
    for (int i = 0; i < TAKEN_AT_ONCE && take_one(n, &tells); i++)
        ;
    test_flights();
    return test_arrivals(n) || tells;
}
