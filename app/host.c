/* host.c - the main program of a group's host.
 *
 * For each layer the host
 *  - opens the layer, so that handlers may hand out its subcubes in the background;
 *  - reads the slice of the next layer meanwhile;
 *  - helps computing subcubes, until only the `keep` subcubes are left that the slaves shall have;
 *  - waits until slaves have asked for these subcubes.
 * After the last layer the host drains the group: it answers each slave's request with NO_MORE, and the slave
 * sends its last polygons and a FIN.
 *
 * Why this cannot stop halfway. The main program waits for two things only.
 *  - FOR_REQUESTS: subcubes are left (at most `keep`) and the group has slaves. Every slave of the group that
 *    is not computing has a request under way or in the host's queue, since a slave asks before it waits. A
 *    slave that was announced and has not asked yet will ask, by its order. Handlers answer requests without
 *    waiting for the main program.
 *  - FOR_SLAVES: the host waits only for slaves that have asked at least once. Such a slave holds one chunk
 *    or waits for the answer to one request. Either way it asks again, gets NO_MORE, and sends FIN. A slave
 *    that asks for the first time after the last layer is discarded: it waits only for node 0's order to end.
 * Handlers wait, too, but only for messages that no other action has to precede: the body of a polygon
 * message is sent at once after its header, and a chunk's receive was posted before its request.
 */
#include <string.h>
#include <nx.h>
#include "fail.h"
#include "host.h"
#include "slices.h"
#include "times.h"

struct host host;

static struct span span;

static void *table(size_t size)
{
    size_t n = numnodes() * size;
    void *p = allocate(n);

    memset(p, 0, n);
    return p;
}

static void add_first_slaves(void)
{
    int node = (int)mynode() + 1, end = (host.group + 1) * host.group_size;

    for (; node < end && node < numnodes(); node++) {
        host.member[node] = host.attached[node] = 1;
        host.members++;
        host.attacheds++;
    }
}

void host_prepare(const struct options *o)
{
    memset(&host, 0, sizeof host);
    host.o = o;
    host.group_size = o->policy.group > 0 ? o->policy.group : (int)numnodes();
    host.groups = (int)(numnodes() + host.group_size - 1) / host.group_size;
    host.group = (int)mynode() / host.group_size;
    host.found = collect_begin(o, (int)mynode());
    host.member = table(sizeof *host.member);
    host.attached = table(sizeof *host.attached);
    host.in_hand = table(sizeof *host.in_hand);
    host.queue = table(sizeof *host.queue);
    host.few_left_at = -1;
    span = group_share(host.group);
    host.later = span.layers;
    add_first_slaves();
    group_begin();
    slices_begin(o, span.first);
}

/* Read the slices of the first layer. C0 data take two slices; C3 data take a third, and a fourth below if
 * there is one. */
void host_read_first(void)
{
    enum activity before = times_enter(READING);

    if (span.layers > 0)
        slices_prepare(span.first + 1);
    times_enter(before);
}

/* While layer j is open: read the next layer's upper slice. */
static void read_ahead(int j)
{
    enum activity before = times_enter(READING);

    if (host.later > 0)
        slices_prepare(j + 2);
    else if (host.o->policy.overlap)
        slices_overlap();
    times_enter(before);
}

static void open_layer(int j)
{
    const struct grid *g = &host.o->grid;
    double start;

    masktrap(1);
    host.layer = slices_layer(j);
    pool_fill(&host.pool, g->ny, g->nx);
    host.later--;
    host.open = 1;
    start = dclock();
    service_queue();
    host.handler_s += dclock() - start;
    service_watch();
    masktrap(0);
}

/* The host's own polygons go directly to the collection. */
static void keep_polygon(int iso, int n, const vertex *v)
{
    masktrap(1);
    collect_polygon(iso, n, v);
    masktrap(0);
}

/* Each subcube that the host helps with is prepared like a chunk. On a single node the layer is one chunk. */
static void help(void)
{
    static struct fit_system system;
    int alone = numnodes() == 1;
    const struct policy *q = &host.o->policy;
    int first, n, i;

    for (;;) {
        masktrap(1);
        n = pool_help(&host.pool, alone ? pool_left(&host.pool) : q->gran, host.members > 0 ? q->keep : 0,
                      &first);
        host.helped += n;
        service_watch();
        masktrap(0);
        if (n == 0)
            return;
        for (i = 0; i < n; i++) {
            layer_prepare(host.o, &system, alone ? i : 0);
            layer_cell(host.o, &system, &host.layer, first + i, keep_polygon);
        }
    }
}

/* Wait until a handler finds service_ready(what) true. Answers the seconds of waiting, less those of the
 * handlers. */
static double wait_for(enum waiting what)
{
    double start, served;
    enum activity before;

    masktrap(1);
    if (service_ready(what)) {
        masktrap(0);
        return 0;
    }
    start = dclock();
    served = host.handler_s;
    host.waiting = what;
    masktrap(0);
    before = times_enter(what == FOR_REQUESTS ? WAIT_REQUESTS : WAIT_SLAVES);
    crecv(WAKE, NULL, 0);
    times_enter(before);
    return dclock() - start - (host.handler_s - served);
}

static void wait_for_requests(void)
{
    double now;

    masktrap(1);
    host.few_left_at = pool_left(&host.pool) <= host.o->grid.nx ? dclock() : -1;
    masktrap(0);
    now = wait_for(FOR_REQUESTS);
    host.idle_s += now;
    if (now > 0 && host.few_left_at >= 0) {
        double last = dclock() - host.few_left_at;

        host.idle_last_s += last < now ? last : now;
    }
}

static void drain(void)
{
    masktrap(1);
    host.stage = DRAINING;
    service_queue();
    masktrap(0);
    host.drain_s += wait_for(FOR_SLAVES);
}

int host_run(void)
{
    int j, next = NOBODY;

    if (numnodes() > 1)
        service_begin();
    host_read_first(); /* nothing to do after a preload */
    for (j = span.first; j < span.first + span.layers; j++) {
        times_layer(j);
        open_layer(j);
        read_ahead(j);
        times_enter(HELPING);
        help();
        times_enter(OTHER);
        wait_for_requests();
        masktrap(1);
        host.open = 0;
        masktrap(0);
        if (host.later > 0)
            group_tell_all(LAYER_FINISHED, host.later);
    }
    times_layer(-1);
    drain();
    times_enter(DEALING);
    masktrap(1);
    host.stage = FINISHED;
    collect_end();
    masktrap(0);
    group_tell_all(GROUP_DONE, 0);
    group_register();
    if (host.o->policy.reassign)
        next = group_deal_nodes();
    times_enter(OTHER);
    return next;
}
