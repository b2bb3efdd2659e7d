/* report.c - sums the measurements over all nodes and prints one "key value" a line. */
#include <stdio.h>
#include <nx.h>
#include "host.h"
#include "report.h"
#include "slave.h"

enum { IDLE_LAST, IDLE_ALL, DRAIN, HANDLER, HELPED, CHUNKS, BODIES, SLAVE_IDLE, SLAVES, SUMS };

static double percent(double part, double whole)
{
    return whole > 0 ? 100.0 * part / whole : 0;
}

static void print_polygons(const struct options *o)
{
    double all = 0;
    int i;

    for (i = 0; i < o->iso.n; i++)
        all += registered.polygons[i];
    printf("polygons %.0f\npolygons_by_isovalue", all);
    for (i = 0; i < o->iso.n; i++)
        printf(" %.0f", registered.polygons[i]);
    printf("\n");
    if (o->each & EACH_HASHED)
        printf("polygon_digest %016llx\n", registered.digest);
}

static void print(const struct options *o, const double *sum, double total_s, double most, double least)
{
    printf("total_s %.6f\n", total_s);
    printf("host_idle_pct %.6f\n", percent(sum[IDLE_LAST] / host.groups, total_s));
    printf("host_idle_all_pct %.6f\n", percent(sum[IDLE_ALL] / host.groups, total_s));
    printf("host_drain_pct %.6f\n", percent(sum[DRAIN] / host.groups, total_s));
    printf("host_handler_pct %.6f\n", percent(sum[HANDLER] / host.groups, total_s));
    if (host.groups == 1 && sum[SLAVES] > 0) {
        printf("slave_idle_pct %.6f\n", percent(sum[SLAVE_IDLE] / sum[SLAVES], total_s));
        if (sum[SLAVES] > 1)
            printf("slave_idle_spread_pct %.6f\n", percent(most - least, total_s));
    }
    print_polygons(o);
    printf("helped_cells %.0f\nchunks %.0f\npolygon_messages %.0f\n", sum[HELPED], sum[CHUNKS], sum[BODIES]);
}

void report(const struct options *o, int is_host, double start_s)
{
    double sum[SUMS] = {0}, most = 0, least = 1e30, work[SUMS];

    if (is_host) {
        sum[IDLE_LAST] = host.idle_last_s;
        sum[IDLE_ALL] = host.idle_s;
        sum[DRAIN] = host.drain_s;
        sum[HANDLER] = host.handler_s;
        sum[HELPED] = host.helped;
        sum[CHUNKS] = host.chunks;
        sum[BODIES] = host.bodies;
    } else {
        sum[SLAVES] = 1;
        sum[SLAVE_IDLE] = most = least = slave_idle_s;
    }
    gdsum(sum, SUMS, work);
    gdhigh(&most, 1, work);
    gdlow(&least, 1, work);
    if (mynode() == 0) {
        masktrap(1);
        print(o, sum, registered.ended_at - start_s, most, least);
        masktrap(0);
    }
}
