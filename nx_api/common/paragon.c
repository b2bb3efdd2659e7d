/* paragon.c - calls by which a Paragon program starts itself on its nodes. Here the program is on its nodes
 * already: each node's process is one of the children, and the program's nodes are the machine. */
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

/* --- nodes and partitions --- */

static long list_of(long n, nx_nodes_t *nodes, unsigned long *count)
{
    if (!nodes || !count)
        return nx_result(EQPBUF);
    if (!(*nodes = malloc((size_t)(n ? n : 1) * sizeof **nodes)))
        return nx_result(ENOMEM);
    for (long i = 0; i < n; i++)
        (*nodes)[i] = i;
    *count = (unsigned long)n;
    return 0;
}

long nx_app_nodes(long process_group, nx_nodes_t *nodes, unsigned long *count)
{
    (void)process_group;
    return list_of(numnodes(), nodes, count);
}

long nx_part_nodes(const char *partition, nx_nodes_t *nodes, unsigned long *count)
{
    (void)partition;
    return list_of(numnodes(), nodes, count);
}

long nx_root_nodes(nx_nodes_t *nodes, unsigned long *count)
{
    return list_of(numnodes(), nodes, count);
}

long nx_empty_nodes(nx_nodes_t *nodes, unsigned long *count)
{
    return list_of(0, nodes, count);
}

long nx_part_attr(const char *partition, nx_part_info_t *attributes)
{
    long rows, columns;
    (void)partition;
    if (!attributes)
        return nx_result(EQPBUF);
    mypart(&rows, &columns);
    *attributes = (nx_part_info_t){.access = 0777,
                                   .sched = NX_SPS,
                                   .epl = NX_MOST_PRIORITY,
                                   .nodes = (int)numnodes(),
                                   .mesh_x = (int)columns,
                                   .mesh_y = (int)rows,
                                   .enclose_mesh_x = (int)columns,
                                   .enclose_mesh_y = (int)rows};
    return 0;
}

long nx_pri(long process_group, long priority)
{
    (void)process_group;
    return nx_result((int)priority < 0 || (int)priority > NX_MOST_PRIORITY ? EINVAL : 0);
}

long mcmsg_wire(void *memory, long bytes)
{
    (void)memory, (void)bytes;
    return 0;
}

void nx_perror(const char *what)
{
    nxperror(what);
}
