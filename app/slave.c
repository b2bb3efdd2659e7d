/* slave.c - requests chunks of subcubes, computes them, sends their polygons.
 *
 * At most one request is under way, and one chunk stored ahead: the receive for the next chunk is posted before the
 * request is sent, so a host never waits for us. Polygons are sent from two buffers by turns.
 */
#include <stddef.h>
#include <nx.h>
#include "fail.h"
#include "layer.h"
#include "messages.h"
#include "slave.h"

double slave_idle_s;

static struct {
    const struct options *o;
    int host;
    /* chunks: one in work, one stored or under way */
    double *chunk[2];
    long receive; /* message id of the next chunk's receive, or -1 when it has come */
    int turn;     /* the buffer it comes to */
    /* polygons */
    double *polygons[2];
    long send[2]; /* message id, or -1 */
    int filling, used, messages;
} slave;

void slave_prepare(const struct options *o)
{
    int i;

    slave.o = o;
    for (i = 0; i < 2; i++) {
        slave.chunk[i] = allocate(chunk_bytes_max(&o->grid));
        slave.polygons[i] = allocate(o->policy.buffer);
        slave.send[i] = -1;
    }
}

static void send_polygons(void)
{
    struct polygons_message header;
    int b = slave.filling;

    if (slave.used == 0)
        return;
    header.doubles = slave.used;
    csend(POLYGONS, &header, sizeof header, slave.host, 0);
    slave.send[b] =
        isend(BODY + mynode(), slave.polygons[b], slave.used * (long)sizeof(double), slave.host, 0);
    slave.messages++;
    slave.used = 0;
    slave.filling = b ^ 1;
}

/* Before the first polygon goes into a buffer its last sending must be complete. */
static void claim_buffer(void)
{
    long *id = &slave.send[slave.filling];

    if (*id >= 0)
        msgwait(*id);
    *id = -1;
}

static void keep_polygon(int iso, int n, const vertex *v)
{
    if ((slave.used + 2 + 6 * n) * (long)sizeof(double) > slave.o->policy.buffer)
        send_polygons();
    if (slave.used == 0)
        claim_buffer();
    slave.used += collect_pack(iso, n, v, slave.polygons[slave.filling] + slave.used);
}

static void request(int buffer)
{
    slave.turn = buffer;
    slave.receive = irecv(CHUNK, slave.chunk[buffer], chunk_bytes_max(&slave.o->grid));
    csend(REQUEST, NULL, 0, slave.host, 0);
}

/* Wait for the chunk that was asked for. The polygons found so far leave before the node idles. */
static struct chunk next_chunk(void)
{
    if (msgdone(slave.receive) == 0) {
        double start;

        if (slave.o->policy.flush == FLUSH_WAIT)
            send_polygons();
        start = dclock();
        msgwait(slave.receive);
        slave_idle_s += dclock() - start;
    }
    slave.receive = -1;
    return chunk_unpack(&slave.o->grid, slave.chunk[slave.turn]);
}

/* Compute a chunk; ask for the next one, into the other buffer, when few subcubes are left. */
static void compute(const struct chunk *c)
{
    int lead = slave.o->policy.lead < c->count ? slave.o->policy.lead : c->count, other = slave.turn ^ 1, i;

    for (i = 0; i < c->count; i++) {
        if (c->count - i == lead)
            request(other);
        layer_cell(slave.o, &c->layer, c->first + i, keep_polygon);
    }
    if (lead == 0)
        request(other);
    if (slave.o->policy.flush == FLUSH_CHUNK)
        send_polygons();
}

static void serve(int host)
{
    struct fin_message fin;
    struct chunk c;

    slave.host = host;
    slave.messages = 0;
    request(slave.turn);
    for (c = next_chunk(); c.kind == CHUNK_WORK; c = next_chunk())
        compute(&c);
    if (c.kind == CHUNK_DISCARD)
        return; /* the host was finished when we came; it does not count us */
    send_polygons();
    fin.messages = slave.messages;
    csend(FIN, &fin, sizeof fin, host, 0);
}

static int next_order(void)
{
    struct order_message order;
    double start = dclock();

    crecv(ORDER, &order, sizeof order);
    slave_idle_s += dclock() - start;
    return order.host;
}

void slave_run(int host)
{
    if (host == NOBODY)
        host = next_order();
    for (; host != NOBODY; host = next_order())
        serve(host);
}
