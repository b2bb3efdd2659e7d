/* main.c - scalar field modelling: isosurfaces of a volume by trivariate approximation, on groups of nodes.
 *
 * All nodes run this program. The first node of each group is its host, the others are its slaves; when a
 * group has finished, its nodes serve the hosts of other groups. Written after C. Bajaj and K.-N. Lin,
 * "Scalar Field Modeling and Visualization on the Intel Delta".
 */
#include <stdio.h>
#include <stdlib.h>
#include <nx.h>
#include "fail.h"
#include "host.h"
#include "report.h"
#include "slave.h"
#include "surfaces.h"
#include "times.h"
#include "volume.h"

/* All nodes read the same command line; only node 0 prints. */
static int read_options(struct options *o, int argc, char **argv)
{
    char error[256];
    int r = options_read(o, argc, argv, error, sizeof error);

    if (r > 0 && mynode() == 0)
        fputs(options_help, stdout);
    if (r < 0 && mynode() == 0)
        fprintf(stderr, "model: %s\n", error);
    return r;
}

static int group_size(const struct options *o)
{
    return o->policy.group > 0 ? o->policy.group : (int)numnodes();
}

/* Fails if the file has another size than the options say. Node 0 checks before any other node opens the
 * file. */
static void check_volume(const struct options *o)
{
    char error[256];

    if (mynode() == 0 && volume_check(o, error, sizeof error))
        fail("%s", error);
    gsync();
}

/* Allocates all memory, and, with -preload, reads the first slices, before the clock starts. */
static void prepare(const struct options *o, int is_host)
{
    if (is_host)
        host_prepare(o);
    if (!is_host || group_size(o) < numnodes())
        slave_prepare(o);
    if (is_host && o->policy.preload)
        host_read_first();
}

static void work(const struct options *o, int is_host)
{
    int host_node = (int)mynode() - (int)mynode() % group_size(o);

    if (is_host)
        host_node = host_run();
    if (numnodes() > 1)
        slave_run(host_node);
}

int main(int argc, char **argv)
{
    static struct options o;
    double start;
    int r = read_options(&o, argc, argv), is_host;

    if (r)
        exit(r < 0);
    if (o.volume)
        check_volume(&o);
    is_host = mynode() % group_size(&o) == 0;
    prepare(&o, is_host);
    gsync();
    start = dclock();
    times_begin(o.times, start, o.grid.slices - 1);
    work(&o, is_host);
    times_end();
    report(&o, is_host, start);
    times_print(is_host);
    surfaces_end(&o, is_host, group_size(&o));
    return 0;
}
