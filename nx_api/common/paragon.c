/* paragon.c - calls by which a program for the Paragon would start itself on its nodes. Here it is there already, so
 * that each node's process is one of the children. */
#include <stdlib.h>
#include "global.h"
#include "nx.h"

long msginfo[8];

long nx_initve(const char *partition, long size, const char *account, int *argc, char *argv[])
{
    (void)partition, (void)size, (void)account, (void)argc, (void)argv;
    return numnodes();
}

long nx_nfork(const long nodes[], long count, long ptype, long pids[])
{
    (void)nodes, (void)count, (void)ptype, (void)pids;
    return 0;
}

long nx_load(const long nodes[], long count, long ptype, long pids[], const char *path)
{
    (void)nodes, (void)count, (void)ptype, (void)pids, (void)path;
    return nx_result(ENOSYS);
}

long nx_waitall(void)
{
    return 0;
}

long nx_app_nodes(long process_group, nx_nodes_t *nodes, unsigned long *count)
{
    long n = numnodes();
    (void)process_group;
    if (!nodes || !count)
        return nx_result(EQPBUF);
    if (!(*nodes = malloc((size_t)n * sizeof **nodes)))
        return nx_result(ENOMEM);
    for (long i = 0; i < n; i++)
        (*nodes)[i] = i;
    *count = (unsigned long)n;
    return 0;
}
