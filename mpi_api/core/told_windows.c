/* told_windows.c - see told_windows.h. */
#include "mpi_api/core/told_windows.h"

const struct win *told_window(const struct nxm_library *l, long pid)
{
    for (int i = 0; i < *l->used; i++) {
        const struct object *o = (*l->table)[i];
        const struct win *w = o && o->kind == WIN ? (const struct win *)o : NULL;
        if (w && w->comm && w->comm->context == (pid & ~1L))
            return w;
    }
    return NULL;
}

int told_node(const struct group *g, int rank)
{
    return g->nodes ? g->nodes[rank] : g->first + rank;
}

/* (A lock that is none, MPI_MODE_NOCHECK, is negative.) */
bool told_locks(const struct win *w, int node)
{
    const struct group *g = w->comm->local;
    for (int r = 0; w->locks && r < g->size; r++)
        if (w->locked[r] > 0 && told_node(g, r) == node)
            return true;
    return false;
}
