/* parts_mpi.h - MPI in the programs of `make prove`: what all ranks do together, chosen by numbers that all
 * have. Every phase ends, whatever the others were. */
#ifndef PROVE_PARTS_MPI_H
#define PROVE_PARTS_MPI_H
#include <mpi.h>
#include <stdbool.h>

enum { MPI_MOST = 25000, MPI_PARTNERS = 3 };
static int mpi_rank, mpi_size;
static char mpi_out[MPI_PARTNERS][MPI_MOST], mpi_in[MPI_PARTNERS][MPI_MOST];

static void mpi_begin(void)
{
    int runs;
    MPI_Initialized(&runs);
    if (!runs)
        MPI_Init(NULL, NULL);
    MPI_Comm_rank(MPI_COMM_WORLD, &mpi_rank);
    MPI_Comm_size(MPI_COMM_WORLD, &mpi_size);
}

static void mpi_note(const MPI_Status *s)
{
    int n;
    MPI_Get_count(s, MPI_CHAR, &n);
    note(s->MPI_SOURCE), note(s->MPI_TAG), note(n);
}

/* Each rank's k-th partner is as many ranks on, so that each is so for one other. */
static int mpi_partner(long seed, int k, int direction)
{
    return (int)((mpi_rank + direction * (seed * 7 + k * 13) % mpi_size + mpi_size) % mpi_size);
}

static void mpi_waits(long how, int count, MPI_Request *r)
{
    MPI_Status s[2 * MPI_PARTNERS];
    int index[2 * MPI_PARTNERS], done, flag = 0;
    switch (how % 4) {
    case 0:
        MPI_Waitall(count, r, s);
        for (int i = 0; i < MPI_PARTNERS; i++)
            mpi_note(&s[i]);
        return;
    case 1:
        for (int i = 0; i < count; i++) {
            MPI_Waitany(count, r, index, s);
            note(*index), mpi_note(s);
        }
        return;
    case 2:
        for (int left = count; left > 0; left -= done) {
            MPI_Waitsome(count, r, &done, index, s);
            note(done);
        }
        return;
    default:
        while (!flag)
            MPI_Testall(count, r, &flag, MPI_STATUSES_IGNORE);
    }
}

/* Messages to and from partners, of all modes, with and without wildcards. */
static void mpi_partners(long how, long bytes, long seed)
{
    MPI_Request r[2 * MPI_PARTNERS];
    bool any_source = seed / 8 % 2, any_tag = seed / 16 % 2;
    for (int k = 0; k < MPI_PARTNERS; k++)
        MPI_Irecv(mpi_in[k], MPI_MOST, MPI_CHAR, any_source ? MPI_ANY_SOURCE : mpi_partner(seed, k, -1),
                  any_tag || any_source ? MPI_ANY_TAG : k, MPI_COMM_WORLD, &r[k]);
    for (int k = 0; k < MPI_PARTNERS; k++) {
        int n = (int)(bytes * (k + mpi_rank) % MPI_MOST), to = mpi_partner(seed, k, 1);
        if ((how + k) % 3 == 0)
            MPI_Isend(mpi_out[k], n, MPI_CHAR, to, k, MPI_COMM_WORLD, &r[MPI_PARTNERS + k]);
        else
            MPI_Issend(mpi_out[k], n, MPI_CHAR, to, k, MPI_COMM_WORLD, &r[MPI_PARTNERS + k]);
    }
    mpi_waits(how, 2 * MPI_PARTNERS, r);
}

/* Messages that are looked for before they are received. */
static void mpi_probes(long how, long bytes, long seed)
{
    MPI_Request r;
    MPI_Status s;
    MPI_Message m;
    int flag = 0;
    MPI_Isend(mpi_out[0], (int)bytes, MPI_CHAR, mpi_partner(seed, 1, 1), 5, MPI_COMM_WORLD, &r);
    if (how % 3 == 0) {
        MPI_Probe(MPI_ANY_SOURCE, 5, MPI_COMM_WORLD, &s);
    } else if (how % 3 == 1) {
        while (!flag)
            MPI_Iprobe(mpi_partner(seed, 1, -1), MPI_ANY_TAG, MPI_COMM_WORLD, &flag, &s);
    } else {
        MPI_Mprobe(MPI_ANY_SOURCE, 5, MPI_COMM_WORLD, &m, &s);
        MPI_Mrecv(mpi_in[0], MPI_MOST, MPI_CHAR, &m, &s);
    }
    mpi_note(&s);
    if (how % 3 < 2)
        MPI_Recv(mpi_in[0], MPI_MOST, MPI_CHAR, s.MPI_SOURCE, s.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    MPI_Wait(&r, MPI_STATUS_IGNORE);
}

static void mpi_reductions(long how, long bytes, MPI_Comm comm)
{
    int n = (int)bytes / 4, *x = (int *)mpi_out[0], *y = (int *)mpi_in[0];
    for (int i = 0; i < n; i++)
        x[i] = (mpi_rank + 1) * (i + 1);
    switch (how % 4) {
    case 0:
        MPI_Allreduce(x, y, n, MPI_INT, MPI_SUM, comm);
        break;
    case 1:
        MPI_Reduce(x, y, n, MPI_INT, MPI_MAX, 0, comm);
        break;
    case 2:
        MPI_Scan(x, y, n, MPI_INT, MPI_SUM, comm);
        break;
    default:
        MPI_Bcast(y, n, MPI_INT, 0, comm);
    }
    note(n ? y[n - 1] : 0);
}

/* A part of each to each, of which every second byte counts. */
static void mpi_parts(long how, long bytes)
{
    int each = (int)bytes / 2 / mpi_size;
    MPI_Datatype halves;
    MPI_Type_vector(each, 1, 2, MPI_CHAR, &halves);
    MPI_Type_create_resized(halves, 0, each ? 2 * each : 1, &halves);
    MPI_Type_commit(&halves);
    for (int i = 0; i < MPI_MOST; i++)
        mpi_out[0][i] = (char)(mpi_rank + i);
    if (how % 3 == 0)
        MPI_Alltoall(mpi_out[0], 1, halves, mpi_in[0], each, MPI_CHAR, MPI_COMM_WORLD);
    else if (how % 3 == 1)
        MPI_Allgather(mpi_out[0], 1, halves, mpi_in[0], each, MPI_CHAR, MPI_COMM_WORLD);
    else
        MPI_Gather(mpi_out[0], 1, halves, mpi_in[0], each, MPI_CHAR, mpi_size - 1, MPI_COMM_WORLD);
    note(each ? mpi_in[0][each * mpi_size - 1] : 0);
    MPI_Type_free(&halves);
}

/* Collectives under way at once, while messages are waited for. */
static void mpi_under_way(long how, long bytes, long seed)
{
    MPI_Request r[4];
    int own = mpi_rank, sum = 0, index;
    MPI_Iallreduce(&own, &sum, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD, &r[0]);
    MPI_Ibcast(mpi_in[1], (int)bytes, MPI_CHAR, (int)(seed % mpi_size), MPI_COMM_WORLD, &r[1]);
    MPI_Ibarrier(MPI_COMM_WORLD, &r[2]);
    MPI_Irecv(mpi_in[0], MPI_MOST, MPI_CHAR, mpi_partner(seed, 2, -1), 6, MPI_COMM_WORLD, &r[3]);
    MPI_Ssend(mpi_out[0], (int)bytes, MPI_CHAR, MPI_PROC_NULL, 6, MPI_COMM_WORLD);
    MPI_Send(mpi_out[0], (int)(bytes % 100), MPI_CHAR, mpi_partner(seed, 2, 1), 6, MPI_COMM_WORLD);
    for (int i = 0; how % 2 && i < 4; i++) {
        MPI_Waitany(4, r, &index, MPI_STATUS_IGNORE);
        note(index);
    }
    MPI_Waitall(4, r, MPI_STATUSES_IGNORE);
    note(sum);
}

static void mpi_comms(long how, long bytes, long seed)
{
    MPI_Comm part, copy;
    MPI_Comm_split(MPI_COMM_WORLD, (int)((mpi_rank + seed) % 3), -mpi_rank, &part);
    MPI_Comm_dup(part, &copy);
    mpi_reductions(how, bytes, copy);
    MPI_Comm_free(&part);
    mpi_reductions(how + 1, bytes % 50, copy);
    MPI_Comm_free(&copy);
}

/* A long message and short ones, which come in the order sent; persistent requests. */
static void mpi_order(long how, long bytes, long seed)
{
    MPI_Request r[2];
    MPI_Status s;
    MPI_Send_init(mpi_out[0], (int)bytes, MPI_CHAR, mpi_partner(seed, 0, 1), 7, MPI_COMM_WORLD, &r[0]);
    MPI_Recv_init(mpi_in[0], MPI_MOST, MPI_CHAR, mpi_partner(seed, 0, -1), MPI_ANY_TAG, MPI_COMM_WORLD,
                  &r[1]);
    for (int i = 0; i < 2; i++) {
        MPI_Start(&r[0]);
        MPI_Send(mpi_out[1], (int)(how % 3), MPI_CHAR, mpi_partner(seed, 0, 1), 8, MPI_COMM_WORLD);
        for (int k = 0; k < 2; k++) {
            MPI_Start(&r[1]);
            MPI_Wait(&r[1], &s);
            mpi_note(&s);
        }
        MPI_Wait(&r[0], MPI_STATUS_IGNORE);
    }
    MPI_Request_free(&r[0]);
    MPI_Request_free(&r[1]);
}

static void mpi_together(long kind, long bytes, long seed)
{
    mpi_begin();
    switch (kind) {
    case 0:
    case 1:
    case 2:
        mpi_partners(seed, bytes, seed / 4);
        break;
    case 3:
        mpi_probes(seed, bytes, seed / 3);
        break;
    case 4:
        mpi_reductions(seed, bytes, MPI_COMM_WORLD);
        break;
    case 5:
        mpi_parts(seed, bytes);
        break;
    case 6:
    case 7:
        mpi_under_way(seed, bytes, seed / 2);
        break;
    case 8:
        mpi_comms(seed, bytes, seed / 4);
        break;
    default:
        mpi_order(seed, bytes, seed / 3);
    }
}
#endif
