/* parts_mpi_more.h - more of MPI in the programs of `make prove`: windows, files, groups of ranks, polls, and
 * errors. Every phase ends, unless a rank makes an error or waits in vain. */
#ifndef PROVE_PARTS_MPI_MORE_H
#define PROVE_PARTS_MPI_MORE_H
#include "parts_mpi.h"

/* Sends from the library's buffer, and exchanges in one call. */
static void mpi_modes(long how, long bytes, long seed)
{
    static char buffer[MPI_MOST + MPI_BSEND_OVERHEAD];
    MPI_Status s;
    MPI_Request r;
    void *back;
    int size, n = (int)bytes, to = mpi_partner(seed, 1, 1), from = mpi_partner(seed, 1, -1);
    MPI_Buffer_attach(buffer, sizeof buffer);
    MPI_Irecv(mpi_in[0], MPI_MOST, MPI_CHAR, from, 20, MPI_COMM_WORLD, &r);
    MPI_Bsend(mpi_out[0], n, MPI_CHAR, to, 20, MPI_COMM_WORLD);
    if (how % 2)
        MPI_Sendrecv_replace(mpi_in[1], n, MPI_CHAR, to, 21, from, 21, MPI_COMM_WORLD, &s);
    else
        MPI_Sendrecv(mpi_out[1], n, MPI_CHAR, to, 21, mpi_in[1], MPI_MOST, MPI_CHAR, MPI_ANY_SOURCE, 21,
                     MPI_COMM_WORLD, &s);
    mpi_note(&s);
    MPI_Wait(&r, &s);
    mpi_note(&s);
    MPI_Buffer_detach(&back, &size);
}

/* Each rank looks whether messages have come, and computes meanwhile: how often it looks depends on time. */
static void mpi_polls(long how, long bytes, long seed)
{
    MPI_Request r[4];
    MPI_Status s[4];
    int index[4], done = 0, looks = 0, left = 4;
    for (int k = 0; k < 2; k++)
        MPI_Irecv(mpi_in[k], MPI_MOST, MPI_CHAR, mpi_partner(seed, k, -1), 22 + k, MPI_COMM_WORLD, &r[k]);
    compute(how % 10, (seed * (mpi_rank + 1)) % 3000);
    for (int k = 0; k < 2; k++)
        MPI_Isend(mpi_out[k], (int)(bytes / (k + 1)), MPI_CHAR, mpi_partner(seed, k, 1), 22 + k,
                  MPI_COMM_WORLD, &r[2 + k]);
    for (; left > 0; looks++) {
        compute(0, seed % 100);
        if (how % 3 == 0) {
            MPI_Testsome(4, r, &done, index, s);
        } else if (how % 3 == 1) {
            MPI_Testany(4, r, index, &done, s);
        } else {
            int k = looks % 4;
            MPI_Request_get_status(r[k], &done, s);
            done = done && r[k] != MPI_REQUEST_NULL;
            if (done)
                MPI_Wait(&r[k], s);
        }
        left -= done;
    }
    note(looks);
}

/* A receive that nothing comes for is cancelled; one that something has come for is not. */
static void mpi_cancels(long how, long bytes, long seed)
{
    MPI_Request r[2], sending;
    MPI_Status s;
    int cancelled;
    MPI_Irecv(mpi_in[0], MPI_MOST, MPI_CHAR, MPI_ANY_SOURCE, 30, MPI_COMM_WORLD, &r[0]);
    MPI_Irecv(mpi_in[1], MPI_MOST, MPI_CHAR, mpi_partner(seed, 0, -1), 31, MPI_COMM_WORLD, &r[1]);
    MPI_Isend(mpi_out[0], (int)bytes, MPI_CHAR, mpi_partner(seed, 0, 1), 31, MPI_COMM_WORLD, &sending);
    compute(how % 10, seed);
    for (int k = 0; k < 2; k++) {
        MPI_Cancel(&r[k]);
        MPI_Wait(&r[k], &s);
        MPI_Test_cancelled(&s, &cancelled);
        note(cancelled);
        if (k == 1 && cancelled)
            MPI_Recv(mpi_in[1], MPI_MOST, MPI_CHAR, mpi_partner(seed, 0, -1), 31, MPI_COMM_WORLD, &s);
    }
    MPI_Wait(&sending, MPI_STATUS_IGNORE);
}

/* Memory of others: between fences, and a counter of one rank whose value tells who came when. */
static void mpi_windows(long how, long bytes, long seed)
{
    MPI_Win w;
    int *base, one = 1, got = 0, count = 1 + (int)bytes / 16;
    MPI_Win_allocate((MPI_Aint)(count * mpi_size * (int)sizeof *base), sizeof *base, MPI_INFO_NULL,
                     MPI_COMM_WORLD, &base, &w);
    memset(base, 0, (size_t)(count * mpi_size) * sizeof *base);
    int *values = (int *)mpi_out[0], to = mpi_partner(seed, 0, 1);
    for (int i = 0; i < count; i++)
        values[i] = mpi_rank + i;
    MPI_Win_fence(0, w);
    if (how % 3 == 0)
        MPI_Put(values, count, MPI_INT, to, (MPI_Aint)mpi_rank * count, count, MPI_INT, w);
    else if (how % 3 == 1)
        MPI_Accumulate(values, count, MPI_INT, 0, 0, count, MPI_INT, MPI_SUM, w);
    else
        MPI_Get(mpi_in[0], count, MPI_INT, to, 0, count, MPI_INT, w);
    MPI_Win_fence(0, w);
    note(base[count * mpi_size - 1]), note(base[0]);
    MPI_Win_fence(0, w);
    for (int k = 0; k < 1 + seed % 3; k++) {
        compute(k, (seed * (mpi_rank + 1)) % 2000);
        MPI_Win_lock(k % 2 ? MPI_LOCK_SHARED : MPI_LOCK_EXCLUSIVE, (int)(seed % mpi_size), 0, w);
        MPI_Fetch_and_op(&one, &got, MPI_INT, (int)(seed % mpi_size), 0, MPI_SUM, w);
        MPI_Win_unlock((int)(seed % mpi_size), w);
        note(got);
    }
    MPI_Win_free(&w);
}

static void mpi_files(long how, long bytes, long seed)
{
    MPI_File f;
    MPI_Status s;
    MPI_Offset size;
    int n = (int)(bytes % 1500), open;
    open =
        MPI_File_open(MPI_COMM_WORLD, "/cfs/prove_mpi", MPI_MODE_CREATE | MPI_MODE_RDWR, MPI_INFO_NULL, &f);
    note(open == MPI_SUCCESS);
    if (open != MPI_SUCCESS)
        return;
    if (how % 3 == 0) {
        MPI_File_write_at_all(f, (MPI_Offset)mpi_rank * n, mpi_out[0], n, MPI_CHAR, &s);
        MPI_File_read_at(f, (MPI_Offset)mpi_partner(seed, 0, 1) * n, mpi_in[0], n, MPI_CHAR, &s);
        mpi_note(&s);
    } else if (how % 3 == 1) {
        MPI_File_write_shared(f, mpi_out[0], n, MPI_CHAR, &s);
        MPI_File_get_position_shared(f, &size);
        note((long)size);
    } else {
        MPI_File_write_ordered(f, mpi_out[0], n, MPI_CHAR, &s);
    }
    MPI_File_get_size(f, &size);
    note((long)size);
    MPI_File_close(&f);
}

/* Two halves that speak with each other, and then are one. */
static void mpi_halves(long how, long bytes, long seed)
{
    MPI_Comm half, inter, one;
    int upper = mpi_rank >= (mpi_size + 1) / 2, mine, sum = 0;
    if (mpi_size < 2)
        return;
    MPI_Comm_split(MPI_COMM_WORLD, upper, seed % 2 ? mpi_rank : -mpi_rank, &half);
    MPI_Comm_rank(half, &mine);
    MPI_Intercomm_create(half, 0, MPI_COMM_WORLD,
                         seed % 2 ? (upper ? 0 : (mpi_size + 1) / 2)
                                  : (upper ? (mpi_size + 1) / 2 - 1 : mpi_size - 1),
                         40, &inter);
    if (how % 3 == 0)
        MPI_Allreduce(&mine, &sum, 1, MPI_INT, MPI_SUM, inter);
    else if (how % 3 == 1)
        MPI_Barrier(inter);
    else
        MPI_Bcast(mpi_in[0], (int)bytes, MPI_CHAR, upper ? 0 : mine == 0 ? MPI_ROOT : MPI_PROC_NULL, inter);
    MPI_Intercomm_merge(inter, !upper, &one);
    mpi_reductions(how, bytes % 100, one);
    note(sum);
    MPI_Comm_free(&one);
    MPI_Comm_free(&inter);
    MPI_Comm_free(&half);
}

/* A ring of ranks, or a torus, and its neighbours. */
static void mpi_torus(long how, long bytes)
{
    MPI_Comm torus;
    int dims[2] = {0}, periods[2] = {1, how % 2 == 0}, dimensions = 1 + (int)(how % 2), from, to;
    MPI_Status s;
    MPI_Dims_create(mpi_size, dimensions, dims);
    MPI_Cart_create(MPI_COMM_WORLD, dimensions, dims, periods, how % 3 == 0, &torus);
    MPI_Cart_shift(torus, dimensions - 1, 1, &from, &to);
    MPI_Sendrecv(mpi_out[0], (int)bytes, MPI_CHAR, to, 0, mpi_in[0], MPI_MOST, MPI_CHAR, from, 0, torus, &s);
    note(s.MPI_SOURCE);
    MPI_Neighbor_allgather(mpi_out[0], (int)bytes / 4, MPI_CHAR, mpi_in[0], (int)bytes / 4, MPI_CHAR, torus);
    MPI_Comm_free(&torus);
}

static void mpi_first_of(void *in, void *inout, int *n, MPI_Datatype *type)
{
    (void)type;
    for (int i = 0; i < *n; i++)
        ((int *)inout)[i] = 3 * ((int *)in)[i] + ((int *)inout)[i];
}

/* Collectives whose ranks have parts of different lengths, or an operation of the program's. */
static void mpi_uneven(long how, long bytes, long seed)
{
    enum { RANKS = 512 };
    static int counts[RANKS], places[RANKS];
    int mine[4] = {mpi_rank, 1, 2, mpi_rank * mpi_rank}, result[4] = {0}, total = 0,
        most = MPI_MOST / mpi_size;
    MPI_Op op;
    if (mpi_size > RANKS)
        return;
    for (int i = 0; i < mpi_size; total += counts[i++])
        counts[i] = (int)((bytes + seed * i) % most), places[i] = total;
    switch (how % 5) {
    case 0:
        MPI_Allgatherv(mpi_out[0], counts[mpi_rank], MPI_CHAR, mpi_in[0], counts, places, MPI_CHAR,
                       MPI_COMM_WORLD);
        break;
    case 1:
        MPI_Scatterv(mpi_out[0], counts, places, MPI_CHAR, mpi_in[0], MPI_MOST, MPI_CHAR, mpi_size - 1,
                     MPI_COMM_WORLD);
        break;
    case 2:
        for (int i = 0; i < mpi_size; i++)
            counts[i] = (int)((bytes + (mpi_rank + i) * seed) % most), places[i] = i * most;
        MPI_Alltoallv(mpi_out[0], counts, places, MPI_CHAR, mpi_in[0], counts, places, MPI_CHAR,
                      MPI_COMM_WORLD);
        break;
    case 3:
        MPI_Exscan(mine, result, 4, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
        break;
    default:
        MPI_Op_create(mpi_first_of, seed % 2, &op);
        MPI_Allreduce(mine, result, 4, MPI_INT, op, MPI_COMM_WORLD);
        MPI_Op_free(&op);
    }
    note(result[3]);
}

/* One rank makes an error, which ends the run or is returned; or it receives what nobody sends. */
static void mpi_errors(long how, long bytes, long seed)
{
    MPI_Comm comm;
    int code = 0, at_fault = mpi_rank == seed % mpi_size;
    MPI_Comm_dup(MPI_COMM_WORLD, &comm);
    if (how % 4)
        MPI_Comm_set_errhandler(comm, MPI_ERRORS_RETURN);
    if (!at_fault)
        MPI_Send(mpi_out[0], (int)bytes, MPI_CHAR, (int)(seed % mpi_size), 50, comm);
    for (int i = 1; at_fault && i < mpi_size; i++) /* some are too long */
        code += MPI_Recv(mpi_in[0], (int)(bytes - i % 2), MPI_CHAR, MPI_ANY_SOURCE, 50, comm,
                         MPI_STATUS_IGNORE) != MPI_SUCCESS;
    if (at_fault && how % 4 == 1)
        code += MPI_Send(mpi_out[0], 1, MPI_CHAR, mpi_size + 3, 50, comm) != MPI_SUCCESS;
    if (at_fault && how % 32 == 2)
        MPI_Recv(mpi_in[0], 1, MPI_CHAR, MPI_ANY_SOURCE, 51, comm, MPI_STATUS_IGNORE);
    if (at_fault && how % 32 == 3)
        MPI_Abort(comm, 3);
    note(code);
    MPI_Comm_free(&comm);
}

static void mpi_more(long kind, long bytes, long seed)
{
    mpi_begin();
    switch (kind) {
    case 0:
        mpi_modes(seed, bytes, seed / 2);
        break;
    case 1:
        mpi_polls(seed, bytes, seed / 3);
        break;
    case 2:
        mpi_cancels(seed, bytes, seed / 10);
        break;
    case 3:
        mpi_windows(seed, bytes, seed / 3);
        break;
    case 4:
        mpi_files(seed, bytes, seed / 3);
        break;
    case 5:
        mpi_halves(seed, bytes, seed / 4);
        break;
    case 6:
        mpi_torus(seed, bytes);
        break;
    case 7:
    case 8:
        mpi_uneven(seed, bytes, seed / 5);
        break;
    default:
        mpi_errors(seed, bytes, seed / 4);
    }
}
#endif
