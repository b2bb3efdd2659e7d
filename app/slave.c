/* slave.c - requests chunks of subcubes, computes them, sends their polygons.
 *
 * At most one request is under way, and one chunk stored ahead. The slave posts the receive for the next
 * chunk before it sends the request, so that a host never waits for a slave. Each surface has two buffers for
 * its polygons: one is filled while the other is sent. A buffer is sent when it is full or the node is about
 * to wait.
 */
#include <stddef.h>
#include <nx.h>
#include "fail.h"
#include "layer.h"
#include "messages.h"
#include "slave.h"
#include "times.h"

double slave_idle_s;

/* The polygons of one surface: buffer[filling] is being filled, the other may be under way. */
struct surface {
    double *buffer[2];
    long send[2]; /* message id of the buffer's last sending, or -1 */
    int filling, used;
};

static struct {
    const struct options *o;
    int host;
    /* chunks: one being computed, one stored or under way */
    double *chunk[2];
    long receive; /* message id of the next chunk's receive, or -1 when it has come */
    int turn;     /* the buffer of the next chunk */
    /* polygons */
    struct surface surface[ISOVALUES_MAX];
    int messages; /* POLYGONS sent to this host */
    int computed; /* a chunk was computed since the last flush */
} slave;

void slave_prepare(const struct options *o)
{
    int i, k;

    slave.o = o;
    for (i = 0; i < 2; i++) {
        slave.chunk[i] = allocate(chunk_bytes_max(o));
        for (k = 0; k < o->iso.n; k++) {
            slave.surface[k].buffer[i] = allocate(o->policy.buffer);
            slave.surface[k].send[i] = -1;
        }
    }
}

static void send_polygons(int iso)
{
    struct surface *s = &slave.surface[iso];
    struct polygons_message header = {iso, s->used};
    enum activity before = times_enter(SENDING);

    csend(POLYGONS, &header, sizeof header, slave.host, 0);
    slave.messages++;
    if (s->used > 0) {
        s->send[s->filling] =
            isend(BODY + mynode(), s->buffer[s->filling], s->used * (long)sizeof(double), slave.host, 0);
        s->filling ^= 1;
        s->used = 0;
    }
    times_enter(before);
}

/* Waits until the last send from a buffer is complete: polygons may then go into it. */
static void claim_buffer(struct surface *s, int buffer)
{
    enum activity before;

    if (s->send[buffer] < 0)
        return;
    before = times_enter(SENDING);
    msgwait(s->send[buffer]);
    times_enter(before);
    s->send[buffer] = -1;
}

/* Sends the polygons of every surface; without -noempty also a message for each surface that has none. Sends
 * nothing before the first chunk: a host that discards this slave does not wait for its messages, and must
 * get none. All buffers are free afterwards. */
static void flush_polygons(void)
{
    int iso, i;

    if (!slave.computed)
        return;
    slave.computed = 0;
    for (iso = 0; iso < slave.o->iso.n; iso++)
        if (slave.surface[iso].used > 0 || slave.o->policy.empty)
            send_polygons(iso);
    for (iso = 0; iso < slave.o->iso.n; iso++)
        for (i = 0; i < 2; i++)
            claim_buffer(&slave.surface[iso], i);
}

static void keep_polygon(int iso, int n, const vertex *v)
{
    struct surface *s = &slave.surface[iso];

    if ((s->used + 1 + 6 * n) * (long)sizeof(double) > slave.o->policy.buffer)
        send_polygons(iso);
    if (s->used == 0)
        claim_buffer(s, s->filling);
    s->used += collect_pack(n, v, s->buffer[s->filling] + s->used);
}

static void request(int buffer)
{
    enum activity before = times_enter(SENDING);

    slave.turn = buffer;
    slave.receive = irecv(CHUNK, slave.chunk[buffer], chunk_bytes_max(slave.o));
    csend(REQUEST, NULL, 0, slave.host, 0);
    times_enter(before);
}

/* Wait for the requested chunk. With -flush wait the polygons found so far are sent before the node waits. */
static struct chunk next_chunk(void)
{
    if (msgdone(slave.receive) == 0) {
        double start;

        if (slave.o->policy.flush == FLUSH_WAIT)
            flush_polygons();
        start = dclock();
        times_enter(WAIT_CHUNK);
        msgwait(slave.receive);
        times_enter(OTHER);
        slave_idle_s += dclock() - start;
    }
    slave.receive = -1;
    return chunk_unpack(&slave.o->grid, slave.chunk[slave.turn]);
}

/* Compute a chunk; request the next one, into the other buffer, when -lead subcubes are left. */
static void compute(const struct chunk *c)
{
    static struct fit_system system;
    int lead = slave.o->policy.lead < c->count ? slave.o->policy.lead : c->count, other = slave.turn ^ 1, i;

    times_enter(COMPUTING);
    for (i = 0; i < c->count; i++) {
        if (c->count - i == lead)
            request(other);
        layer_prepare(slave.o, &system, i);
        layer_cell(slave.o, &system, &c->layer, c->first + i, keep_polygon);
    }
    times_enter(OTHER);
    slave.computed = 1;
    if (lead == 0)
        request(other);
    if (slave.o->policy.flush == FLUSH_CHUNK)
        flush_polygons();
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
        return; /* the host was finished; this slave is none of those it waits for */
    flush_polygons();
    fin.messages = slave.messages;
    csend(FIN, &fin, sizeof fin, host, 0);
}

static int next_order(void)
{
    struct order_message order;
    double start = dclock();

    times_enter(WAIT_ORDER);
    crecv(ORDER, &order, sizeof order);
    times_enter(OTHER);
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
