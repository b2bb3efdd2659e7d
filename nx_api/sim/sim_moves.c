/* sim_moves.c - what MPI's library asks of files (mpi_api/core/core.h): movements, as of NX's calls, under
 * the names of MPI's. */
#include "cfs/cfs.h"
#include "guest/libc/descriptors.h"
#include "mpi_api/core/completion.h"
#include "nx_api/calls/call.h"

static struct node *enter(int call)
{
    struct node *n = node_self();
    node_enter(n, completion_call_name(call));
    nx_begins_call(n);
    return n;
}

long node_nxm_move(const struct nxm_move *m);
long node_nxm_move(const struct nxm_move *m)
{
    struct node *n = enter(m->call);
    const struct iovec part = {m->buf, (size_t)m->bytes};
    return nx_returning(n, nx_move(m->write, m->fd, m->at, &part, 1));
}

long node_nxm_imove(const struct nxm_move *m);
long node_nxm_imove(const struct nxm_move *m)
{
    struct node *n = enter(m->call);
    const struct iovec part = {m->buf, (size_t)m->bytes};
    return nx_returning(n, nx_move_later(m->write, m->fd, m->at, &part, 1));
}

/* iodone() does not tell how many bytes it was, so that it is asked only whether iowait() would wait. */
long node_nxm_moved(int call, long id, int wait);
long node_nxm_moved(int call, long id, int wait)
{
    struct node *n = enter(call);
    const struct cfs_op *op = descriptors_open(n)->io[id - 1].op;
    node_order(n);
    if (wait || !op || cfs_done(n, op))
        return nx_returning(n, nxs_iowait((word)id));
    nx_spend_call(n);
    return nx_returning(n, NXM_UNDER_WAY);
}
