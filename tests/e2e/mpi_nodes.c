/* mpi_nodes.c - MPI's calls on simulated nodes: each line that rank 0 prints is a check over all ranks. */
#define MPI_H /* the guard of a header of some program's own (PhyML's) is none of mpi.h's */
#include <limits.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "mpi_all.h"

/* What the library sends a message by, in a communicator behind the last (mpi_api/core/core.h). */
struct nxm_envelope {
    int call, tag, node, context;
};
long nxm_send(const struct nxm_envelope *e, const void *buf, long len, int held);

/* A long message, and then a short one of another tag: they come in the order sent, whichever is complete
 * first. */
static void order(void)
{
    enum { LONG = 40000 };
    static char out[LONG], in[LONG];
    MPI_Status first, second;
    int holds = 1, n;
    if (rank == 0) {
        MPI_Send(out, LONG, MPI_CHAR, 1, 1, MPI_COMM_WORLD);
        MPI_Send(out, 1, MPI_CHAR, 1, 2, MPI_COMM_WORLD);
    } else if (rank == 1) {
        MPI_Probe(0, MPI_ANY_TAG, MPI_COMM_WORLD, &first);
        holds = first.MPI_TAG == 1;
        MPI_Recv(in, LONG, MPI_CHAR, MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &first);
        MPI_Recv(in, LONG, MPI_CHAR, MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &second);
        MPI_Get_count(&first, MPI_CHAR, &n);
        holds = holds && first.MPI_TAG == 1 && n == LONG && second.MPI_TAG == 2;
    }
    all("messages of one rank come in the order sent", holds);
}

/* A synchronous send is done when its receive has begun, however short; a standard one at once. */
static void synchronous(void)
{
    double begin = MPI_Wtime(), took = 0;
    int x = 0, holds = 1;
    if (rank == 0) {
        MPI_Ssend(&x, 1, MPI_INT, 1, 3, MPI_COMM_WORLD);
        took = MPI_Wtime() - begin;
        begin = MPI_Wtime();
        MPI_Send(&x, 1, MPI_INT, 1, 3, MPI_COMM_WORLD);
        holds = took > 0.4 && MPI_Wtime() - begin < 0.01;
    } else if (rank == 1) {
        while (MPI_Wtime() - begin < 0.5)
            continue;
        MPI_Recv(&x, 1, MPI_INT, 0, 3, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        MPI_Recv(&x, 1, MPI_INT, 0, 3, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    }
    all("a synchronous send waits for its receive", holds);
}

/* A barrier with a request goes on while its rank is blocked in a receive. */
static void progress(void)
{
    MPI_Request barrier;
    int x = 0;
    MPI_Ibarrier(MPI_COMM_WORLD, &barrier);
    if (rank == 0)
        MPI_Recv(&x, 1, MPI_INT, 1, 4, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    MPI_Wait(&barrier, MPI_STATUS_IGNORE);
    if (rank == 1) {
        x = 17;
        MPI_Send(&x, 1, MPI_INT, 0, 4, MPI_COMM_WORLD);
    }
    all("collectives go on in blocked calls", rank != 0 || x == 17);
}

/* A column of a matrix to the next rank, and the sum of it with an operation that does not commute. */
static void left_minus(void *in, void *inout, int *count, MPI_Datatype *type)
{
    int *x = in, *y = inout;
    (void)type;
    for (int i = 0; i < *count; i++)
        y[i] = 2 * x[i] + y[i];
}

/* How many parts of a kind a type has that was made of others. Programs list all combiners in one switch,
 * those that MPI-3 has removed, too. */
static int parts_of(MPI_Datatype type)
{
    int ints, addresses, types, combiner;
    MPI_Type_get_envelope(type, &ints, &addresses, &types, &combiner);
    switch (combiner) {
    case MPI_COMBINER_VECTOR:
    case MPI_COMBINER_HVECTOR:
    case MPI_COMBINER_HVECTOR_INTEGER:
        return ints;
    case MPI_COMBINER_HINDEXED:
    case MPI_COMBINER_HINDEXED_INTEGER:
    case MPI_COMBINER_STRUCT:
    case MPI_COMBINER_STRUCT_INTEGER:
        return addresses;
    case MPI_COMBINER_F90_REAL:
    case MPI_COMBINER_F90_COMPLEX:
    case MPI_COMBINER_F90_INTEGER:
        return types;
    default:
        return -1;
    }
}

/* A part of no data and no marks adds nothing to a type's extents, wherever it is. */
static void empty_parts(void)
{
    const int counts[] = {1, 3};
    const MPI_Aint places[] = {0, 400};
    MPI_Aint lb, extent, true_lb, true_extent;
    MPI_Datatype types[] = {MPI_INT, MPI_DATATYPE_NULL}, whole;
    MPI_Type_contiguous(0, MPI_DOUBLE, &types[1]);
    MPI_Type_create_struct(2, counts, places, types, &whole);
    MPI_Type_get_extent(whole, &lb, &extent);
    MPI_Type_get_true_extent(whole, &true_lb, &true_extent);
    all("parts without data add nothing", lb == 0 && extent == 4 && true_lb == 0 && true_extent == 4);
    MPI_Type_free(&whole);
    MPI_Type_free(&types[1]);
}

static void types_and_operations(void)
{
    int matrix[5][4], column[5], expected = 0, sum, holds = 1;
    MPI_Datatype of_column;
    MPI_Op op;
    for (int i = 0; i < 20; i++)
        matrix[i / 4][i % 4] = 100 * rank + i;
    MPI_Type_vector(5, 1, 4, MPI_INT, &of_column);
    MPI_Type_commit(&of_column);
    MPI_Sendrecv(&matrix[0][1], 1, of_column, (rank + 1) % size, 5, column, 5, MPI_INT,
                 (rank + size - 1) % size, 5, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    holds = parts_of(of_column) == 3;
    MPI_Type_free(&of_column);
    for (int i = 0; i < 5; i++)
        holds = holds && column[i] == 100 * ((rank + size - 1) % size) + 4 * i + 1;
    all("a column of a matrix is sent", holds);
    MPI_Op_create(left_minus, 0, &op);
    int own = rank + 1;
    MPI_Allreduce(&own, &sum, 1, MPI_INT, op, MPI_COMM_WORLD);
    /* Any grouping of the ranks' order gives another number, so that only all ranks' agreement is checked. */
    MPI_Bcast(memcpy(&expected, &sum, sizeof sum), 1, MPI_INT, 0, MPI_COMM_WORLD);
    MPI_Op_free(&op);
    all("an operation of the program's", sum == expected);
}

/* Collectives of all lengths against sums by hand. */
/* MPI_Dims_create has nothing to do if all sides are given, also of fewer nodes. */
static void sides_given(void)
{
    int sides[] = {1, 1};
    all("sides that are all given stay", !MPI_Dims_create(size, 2, sides) && sides[0] == 1 && sides[1] == 1);
}

static void collectives(void)
{
    int holds = 1;
    for (int n = 1; n <= 20000; n *= 27) {
        int *x = malloc((size_t)n * sizeof *x), *y = malloc((size_t)n * sizeof *y);
        int *all_of = malloc((size_t)(n * size) * sizeof *all_of),
            *back = malloc((size_t)(n * size) * sizeof *back);
        for (int i = 0; i < n; i++)
            x[i] = rank * i % 1000;
        MPI_Allreduce(x, y, n, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
        for (int i = 0, sum = 0; i < n; i++, sum = 0) {
            for (int r = 0; r < size; r++)
                sum += r * i % 1000;
            holds = holds && y[i] == sum;
        }
        MPI_Allgather(x, n, MPI_INT, all_of, n, MPI_INT, MPI_COMM_WORLD);
        for (int k = 0; k < n * size; k++)
            holds = holds && all_of[k] == k / n * (k % n) % 1000;
        MPI_Alltoall(all_of, n, MPI_INT, back, n, MPI_INT, MPI_COMM_WORLD);
        for (int k = 0; k < n * size; k++)
            holds = holds && back[k] == rank * (k % n) % 1000;
        MPI_Bcast(x, n, MPI_INT, size - 1, MPI_COMM_WORLD);
        for (int i = 0; i < n; i++)
            holds = holds && x[i] == (size - 1) * i % 1000;
        free(x), free(y), free(all_of), free(back);
    }
    all("collectives of all lengths", holds);
}

/* Two halves, and a communicator of both. */
static void communicators(void)
{
    MPI_Comm half, between, merged;
    int other, n, holds;
    MPI_Comm_split(MPI_COMM_WORLD, rank % 2, -rank, &half);
    /* The key turns the order round: the first rank of a half is the highest. */
    MPI_Intercomm_create(half, 0, MPI_COMM_WORLD, size - 1 - (rank + size) % 2, 6, &between);
    MPI_Comm_remote_size(between, &n);
    MPI_Allreduce(&rank, &other, 1, MPI_INT, MPI_MAX, between);
    holds = n == (rank % 2 ? (size + 1) / 2 : size / 2) && other % 2 != rank % 2;
    MPI_Intercomm_merge(between, rank % 2, &merged);
    MPI_Comm_size(merged, &n);
    holds = holds && n == size;
    MPI_Comm_free(&merged);
    MPI_Comm_free(&between);
    MPI_Comm_free(&half);
    all("communicators of one group and of two", holds);
}

/* An error is returned to those who ask for that. */
static void errors(void)
{
    int x = 0, code, kind;
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    code = MPI_Send(&x, 1, MPI_INT, size, 7, MPI_COMM_WORLD);
    MPI_Error_class(code, &kind);
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_ARE_FATAL);
    all("an error is returned", kind == MPI_ERR_RANK);
}

int main(int argc, char **argv)
{
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    order();
    synchronous();
    progress();
    types_and_operations();
    empty_parts();
    sides_given();
    collectives();
    communicators();
    errors();
    if (argc > 1 && rank == 1) {
        char few[2];
        if (!strcmp(argv[1], "rank"))
            MPI_Send(few, 1, MPI_CHAR, size, 8, MPI_COMM_WORLD);
        if (!strcmp(argv[1], "context"))
            nxm_send(&(const struct nxm_envelope){.node = 0, .context = INT_MIN}, few, 1, 0);
        MPI_Recv(few, 2, MPI_CHAR, 0, 9, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    } else if (argc > 1 && rank == 0) {
        MPI_Send("too long", 9, MPI_CHAR, 1, 9, MPI_COMM_WORLD);
    }
    MPI_Finalize();
    return 0;
}
