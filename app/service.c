/* service.c - the handlers of a host: requests, polygons, FINs, control messages.
 *
 * Each handler handles its message, posts itself again, and ends the main program's wait if its condition
 * holds.
 */
#include <nx.h>
#include "fail.h"
#include "host.h"
#include "times.h"

/* A buffer for a chunk under way. The host uses a few buffers in a cycle and waits only if the next buffer is
 * still being sent. */
struct outgoing {
    double *message;
    long id; /* of the last send from this buffer, or -1 */
};

static struct outgoing *outgoing;
static int outgoings, next_outgoing;

static struct polygons_message header;
static struct fin_message fin;
static struct control_message *control;
static long control_bytes;
static double *body;

static void on_request(long type, long count, long node, long pid);
static void on_polygons(long type, long count, long node, long pid);
static void on_fin(long type, long count, long node, long pid);
static void on_control(long type, long count, long node, long pid);

/* Allocates as many buffers as -buffers says, or as there is room for. One suffices; the host then waits more
 * often. */
static void allocate_outgoing(void)
{
    size_t bytes = chunk_bytes_max(host.o);
    double *message = allocate(bytes);

    outgoing = allocate(host.o->policy.buffers * sizeof *outgoing);
    while (message) {
        outgoing[outgoings].message = message;
        outgoing[outgoings].id = -1;
        message = ++outgoings < host.o->policy.buffers ? allocate_if_room(bytes) : NULL;
    }
}

void service_begin(void)
{
    body = allocate(host.o->policy.buffer);
    control_bytes = (long)sizeof *control + numnodes() * (long)sizeof(int);
    control = allocate(control_bytes);
    allocate_outgoing();
    hrecv(REQUEST, NULL, 0, on_request);
    hrecv(POLYGONS, &header, sizeof header, on_polygons);
    hrecv(FIN, &fin, sizeof fin, on_fin);
    hrecv(CONTROL, control, control_bytes, on_control);
}

double host_unfinished(void)
{
    double cells = host.all_in_hand;

    if (host.open)
        cells += pool_left(&host.pool);
    return host.later + cells / grid_cells(&host.o->grid);
}

void service_watch(void)
{
    if (host.groups == 1 || host.half_told || host.stage != WORKING ||
        host_unfinished() > host.o->policy.half)
        return;
    host.half_told = 1;
    group_tell_all(HALF_LEFT, 0);
}

int service_ready(enum waiting what)
{
    if (what == FOR_REQUESTS)
        return pool_left(&host.pool) == 0;
    return host.fins == host.attacheds && host.bodies == host.bodies_sent;
}

static void wake(void)
{
    if (host.waiting == NOT || !service_ready(host.waiting))
        return;
    host.waiting = NOT;
    csend(WAKE, NULL, 0, mynode(), 0);
}

static struct outgoing *free_buffer(void)
{
    struct outgoing *b = &outgoing[next_outgoing];

    next_outgoing = (next_outgoing + 1) % outgoings;
    if (b->id >= 0)
        msgwait(b->id);
    return b;
}

static void send_word(enum chunk_kind kind, int node)
{
    double message[8];

    csend(CHUNK, message, chunk_pack_word(kind, message), node, 0);
}

static void hand_out(int node)
{
    const struct policy *q = &host.o->policy;
    struct outgoing *b = free_buffer();
    int first, n = pool_chunk(&host.pool, q->k, host.members + 1, q->min_rows, &first);
    enum activity before = times_enter(PACKING);
    long bytes = chunk_pack(&host.o->grid, &host.layer, first, n, b->message);

    times_enter(before);
    b->id = isend(CHUNK, b->message, bytes, node, 0);
    host.in_hand[node] = n;
    host.all_in_hand += n;
    host.chunks++;
    if (host.waiting == FOR_REQUESTS && host.few_left_at < 0 && pool_left(&host.pool) <= host.o->grid.nx)
        host.few_left_at = dclock();
}

/* Answer a request. Returns 0, and does nothing, if there is nothing to hand out yet. */
static int answer(int node)
{
    if (host.stage == DRAINING)
        send_word(CHUNK_NO_MORE, node);
    else if (host.open && pool_left(&host.pool) > 0)
        hand_out(node);
    else
        return 0;
    return 1;
}

void service_queue(void)
{
    int served = 0, i;

    while (served < host.queued && answer(host.queue[served]))
        served++;
    host.queued -= served;
    for (i = 0; i < host.queued; i++)
        host.queue[i] = host.queue[served + i];
}

/* A node belongs to the group from its first request on, announced or not. */
static void attach(int node)
{
    if (!host.member[node]) {
        host.member[node] = 1;
        host.members++;
    }
    host.attached[node] = 1;
    host.attacheds++;
}

static void on_request(long type, long count, long node, long pid)
{
    double start = dclock();
    enum activity before = times_enter(ANSWERING);

    (void)type, (void)count, (void)pid;
    hrecv(REQUEST, NULL, 0, on_request);
    if (host.stage == FINISHED || (host.stage == DRAINING && !host.attached[node]))
        send_word(CHUNK_DISCARD, (int)node);
    else {
        if (!host.attached[node])
            attach((int)node);
        host.all_in_hand -= host.in_hand[node];
        host.in_hand[node] = 0;
        if (!answer((int)node))
            host.queue[host.queued++] = (int)node;
        service_watch();
    }
    wake();
    times_enter(before);
    host.handler_s += dclock() - start;
}

/* The body follows its header at once; its polygons go to the surface's list. */
static void on_polygons(long type, long count, long node, long pid)
{
    double start = dclock();
    enum activity before = times_enter(COLLECTING);

    (void)type, (void)count, (void)pid;
    if (header.doubles > 0) {
        crecv(BODY + node, body, host.o->policy.buffer);
        collect_packed(header.iso, body, header.doubles);
    }
    host.bodies++;
    hrecv(POLYGONS, &header, sizeof header, on_polygons);
    wake();
    times_enter(before);
    host.handler_s += dclock() - start;
}

static void on_fin(long type, long count, long node, long pid)
{
    enum activity before = times_enter(NEWS);

    (void)type, (void)count, (void)node, (void)pid;
    host.fins++;
    host.bodies_sent += fin.messages;
    hrecv(FIN, &fin, sizeof fin, on_fin);
    wake();
    times_enter(before);
}

static void on_control(long type, long count, long node, long pid)
{
    double start = dclock();
    enum activity before = times_enter(NEWS);

    (void)type, (void)count, (void)node, (void)pid;
    group_handle_control(control);
    hrecv(CONTROL, control, control_bytes, on_control);
    times_enter(before);
    host.handler_s += dclock() - start;
}
