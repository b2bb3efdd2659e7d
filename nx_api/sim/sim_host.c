/* sim_host.c - the calls by which a host program manages a cube of nodes: what they do is in
 * sim/machine/cube.h. */
#include <errno.h>
#include <stddef.h>
#include <string.h>
#include "machine/cube.h"
#include "nx_api/include/host.h"
#include "nx_api/calls/call.h"

/* The caller, if it is the host program; NULL with the error. */
static struct node *host(void)
{
    struct node *n = node_self();
    if (n->is_host)
        return n;
    node_error(n, ENOSYS, "%s",
               n->sys->cube ? "only the host program may call it"
                            : "there is no host program: touchstone run --host HOST runs one, and "
                              "without it loads the one program on all nodes itself");
    return NULL;
}

long nxs_getcube(const char *name, const char *type, const char *srm, word keep)
{
    struct node *n = host();
    (void)srm, (void)keep;
    return n ? cube_get(n, name, type) : -1;
}

long nxs_attachcube(const char *name)
{
    struct node *n = host();
    return n ? cube_attach(n, name) : -1;
}

long nxs_relcube(const char *name)
{
    struct node *n = host();
    return n ? cube_release(n, name) : -1;
}

long nxs_load(const char *path, word node, word pid)
{
    struct node *n = host();
    return n ? cube_load(n, path, node, pid) : -1;
}

long nxs_waitcube(void)
{
    struct node *n = host();
    if (!n)
        return -1;
    return nxs_waitall(ALL_NODES, 0);
}

long nxs_cubeinfo(struct cubeinfo *table, word slots, word global)
{
    struct node *n = host();
    (void)global;
    if (!n)
        return -1;
    if (slots < 0 || (slots > 0 && !table))
        return node_error(n, EQPBUF, "the table is a null pointer, or has %d slots", slots);
    const char *name = cube_name(n->sys->cube);
    nx_spend_call(n);
    if (name && slots > 0) {
        memset(table, 0, offsetof(struct cubeinfo, nodes));
        node_put_long(n, &table->nodes, 0, n->sys->count);
        snprintf(table->cubename, sizeof table->cubename, "%s", name);
        snprintf(table->cubetype, sizeof table->cubetype, "%u", n->sys->count);
    }
    return name != NULL;
}
