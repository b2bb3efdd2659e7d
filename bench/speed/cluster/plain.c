/* plain.c - see plain.h. As one writes it for MPI, and on a communicator of its own. */
#include "plain.h"
#include <mpi.h>
#include <string.h>

static MPI_Comm comm;
static int me, nodes;

void plain_begin(void)
{
    MPI_Comm_dup(MPI_COMM_WORLD, &comm);
    MPI_Comm_rank(comm, &me);
    MPI_Comm_size(comm, &nodes);
}

/* Nodes 0 and 1. */
void plain_ping_pong(char *out, char *in, int bytes, int rounds)
{
    for (int i = 0; i < rounds && me < 2; i++) {
        if (me == 0)
            MPI_Send(out, bytes, MPI_BYTE, 1, 1, comm);
        MPI_Recv(in, bytes, MPI_BYTE, 1 - me, 1, comm, MPI_STATUS_IGNORE);
        if (me == 1)
            MPI_Send(out, bytes, MPI_BYTE, 0, 1, comm);
    }
}

/* A ring of nodes: each exchanges its two edges with its two neighbours. */
void plain_halo(char *out, char *in, int bytes, int rounds)
{
    int left = (me + nodes - 1) % nodes, right = (me + 1) % nodes;
    for (int i = 0; i < rounds; i++) {
        MPI_Request r[4];
        MPI_Irecv(in, bytes, MPI_BYTE, left, 2, comm, &r[0]);
        MPI_Irecv(in + bytes, bytes, MPI_BYTE, right, 3, comm, &r[1]);
        MPI_Isend(out, bytes, MPI_BYTE, right, 2, comm, &r[2]);
        MPI_Isend(out + bytes, bytes, MPI_BYTE, left, 3, comm, &r[3]);
        MPI_Waitall(4, r, MPI_STATUSES_IGNORE);
    }
}

void plain_sum(double *x, double *work, int count, int rounds)
{
    for (int i = 0; i < rounds; i++) {
        MPI_Allreduce(x, work, count, MPI_DOUBLE, MPI_SUM, comm);
        memcpy(x, work, (size_t)count * sizeof *x);
    }
}

void plain_barrier(int rounds)
{
    for (int i = 0; i < rounds; i++)
        MPI_Barrier(comm);
}
