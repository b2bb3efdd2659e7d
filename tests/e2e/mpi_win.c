/* mpi_win.c - MPI's windows on simulated nodes: each line that rank 0 prints is a check over all ranks. */
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "mpi_all.h"

/* Each rank puts into the next, gets from the one before, and adds to rank 0. */
static void fence(void)
{
    enum { LONG = 3000 };
    static int memory[2 * LONG + 2], out[LONG], in[LONG];
    int next = (rank + 1) % size, before = (rank + size - 1) % size, holds = 1;
    MPI_Win win;
    for (int i = 0; i < LONG; i++)
        memory[i] = 1000000 * rank + i, out[i] = -(1000000 * rank + i);
    MPI_Win_create(memory, sizeof memory, sizeof(int), MPI_INFO_NULL, MPI_COMM_WORLD, &win);
    MPI_Win_fence(MPI_MODE_NOPRECEDE, win);
    MPI_Get(in, LONG, MPI_INT, before, 0, LONG, MPI_INT, win);
    MPI_Put(out, LONG, MPI_INT, next, LONG, LONG, MPI_INT, win);
    MPI_Accumulate(&rank, 1, MPI_INT, 0, 2 * LONG, 1, MPI_INT, MPI_SUM, win);
    MPI_Accumulate(&rank, 1, MPI_INT, 0, 2 * LONG + 1, 1, MPI_INT, MPI_MAX, win);
    MPI_Put(out, 1, MPI_INT, MPI_PROC_NULL, 0, 1, MPI_INT, win);
    holds = in[1] == 0 && memory[LONG + 1] == 0; /* not yet */
    MPI_Win_fence(0, win);
    for (int i = 0; i < LONG; i++)
        holds = holds && in[i] == 1000000 * before + i && memory[LONG + i] == -(1000000 * before + i);
    if (rank == 0)
        holds = holds && memory[2 * LONG] == size * (size - 1) / 2 && memory[2 * LONG + 1] == size - 1;
    MPI_Put(&rank, 1, MPI_INT, next, 0, 1, MPI_INT, win);
    MPI_Win_fence(MPI_MODE_NOSUCCEED, win);
    holds = holds && memory[0] == before;
    MPI_Win_free(&win);
    all("from fence to fence: puts, gets and sums", holds && win == MPI_WIN_NULL);
}

/* A column of the target's matrix from a row, and back; pairs with a hole. */
static void datatypes(void)
{
    enum { SIDE = 30 };
    static double matrix[SIDE][SIDE], row[SIDE], back[SIDE][2];
    static struct pair {
        double value;
        int index;
    } pairs[2] = {{-1, -1}, {-1, -1}}, own;
    int next = (rank + 1) % size, before = (rank + size - 1) % size, holds = 1;
    MPI_Datatype column, second;
    MPI_Win win, of_pairs;
    MPI_Type_vector(SIDE, 1, SIDE, MPI_DOUBLE, &column);
    MPI_Type_vector(SIDE, 1, 2, MPI_DOUBLE, &second);
    MPI_Type_commit(&column);
    MPI_Type_commit(&second);
    MPI_Win_create(matrix, sizeof matrix, sizeof(double), MPI_INFO_NULL, MPI_COMM_WORLD, &win);
    MPI_Win_create(pairs, sizeof pairs, sizeof pairs[0], MPI_INFO_NULL, MPI_COMM_WORLD, &of_pairs);
    for (int i = 0; i < SIDE; i++)
        row[i] = 100 * rank + i;
    MPI_Win_fence(0, win);
    MPI_Put(row, SIDE, MPI_DOUBLE, next, 3, 1, column, win);
    MPI_Type_free(&column); /* it lives as long as it is needed */
    MPI_Win_fence(0, win);
    for (int i = 0; i < SIDE; i++)
        holds = holds && matrix[i][3] == 100 * before + i && matrix[i][4] == 0;
    MPI_Accumulate(row, SIDE, MPI_DOUBLE, next, 3 * SIDE, SIDE, MPI_DOUBLE, MPI_SUM, win);
    MPI_Win_fence(0, win);
    MPI_Get(&back[0][1], 1, second, next, 3 * SIDE, SIDE, MPI_DOUBLE, win);
    MPI_Win_fence(0, win);
    for (int i = 0; i < SIDE; i++)
        holds = holds && back[i][0] == 0 && back[i][1] == 100 * rank + i + (i == 3 ? 100 * rank + 3 : 0);
    own.value = rank % 3, own.index = rank;
    MPI_Win_fence(0, of_pairs);
    MPI_Accumulate(&own, 1, MPI_DOUBLE_INT, 0, 1, 1, MPI_DOUBLE_INT, MPI_MAXLOC, of_pairs);
    MPI_Win_fence(0, of_pairs);
    if (rank == 0)
        holds = holds && pairs[0].index == -1 && pairs[1].index == (size > 2 ? 2 : size - 1);
    static struct long_pair { /* whose copies want them aligned, wherever a message has them */
        long double value;
        int index;
    } longs[3];
    struct long_pair one = {1.5L, rank};
    MPI_Win of_longs;
    MPI_Win_create(longs, sizeof longs, sizeof longs[0], MPI_INFO_NULL, MPI_COMM_WORLD, &of_longs);
    MPI_Win_fence(0, of_longs);
    MPI_Accumulate(&one, 1, MPI_LONG_DOUBLE_INT, 0, 1, 1, MPI_LONG_DOUBLE_INT, MPI_MAXLOC, of_longs);
    MPI_Win_fence(MPI_MODE_NOSUCCEED, of_longs);
    if (rank == 0)
        holds = holds && longs[0].value == 0 && longs[1].value == 1.5L && longs[1].index == 0;
    MPI_Win_free(&of_longs);
    MPI_Win_free(&win);
    MPI_Win_free(&of_pairs);
    MPI_Type_free(&second);
    all("datatypes of both sides, with holes", holds);
}

/* Even ranks access odd ones, which wait for them alone. */
static void post(void)
{
    int memory[4] = {0}, got = -1, holds = 1, partner = rank ^ 1, flag = 0;
    MPI_Group world, other;
    MPI_Win win;
    MPI_Comm_group(MPI_COMM_WORLD, &world);
    MPI_Win_create(memory, sizeof memory, sizeof(int), MPI_INFO_NULL, MPI_COMM_WORLD, &win);
    if (partner < size) {
        MPI_Group_incl(world, 1, &partner, &other);
        for (int round = 1; round <= 3; round++) {
            int value = 10 * rank + round;
            if (rank % 2 == 0) {
                MPI_Win_start(other, 0, win);
                MPI_Put(&value, 1, MPI_INT, partner, round, 1, MPI_INT, win);
                MPI_Get(&got, 1, MPI_INT, partner, 0, 1, MPI_INT, win);
                MPI_Win_complete(win);
                holds = holds && got == 7 * round;
            } else {
                memory[0] = 7 * round;
                MPI_Win_post(other, 0, win);
                if (round < 3)
                    MPI_Win_wait(win);
                for (flag = round < 3; !flag;)
                    MPI_Win_test(win, &flag);
                holds = holds && memory[round] == 10 * partner + round;
            }
        }
        MPI_Group_free(&other);
    }
    MPI_Win_free(&win);
    MPI_Group_free(&world);
    all("start, complete, post, wait", holds);
}

/* Each rank is accessed by the one before while it accesses the next, and may wait for a message before it
 * waits for the end of the accesses. */
static void ring(void)
{
    enum { LONG = 50000 };
    static int memory[LONG + 1], out[LONG];
    int next = (rank + 1) % size, before = (rank + size - 1) % size, holds = 1, got, told = -1;
    MPI_Group world, to, from;
    MPI_Win win;
    MPI_Comm_group(MPI_COMM_WORLD, &world);
    MPI_Group_incl(world, 1, &next, &to);
    MPI_Group_incl(world, 1, &before, &from);
    MPI_Win_create(memory, sizeof memory, sizeof(int), MPI_INFO_NULL, MPI_COMM_WORLD, &win);
    for (int round = 0; round < 3; round++) {
        for (int i = 0; i < LONG; i++)
            out[i] = 1000 * rank + i + round;
        memory[LONG] = 7 * rank + round, got = -1;
        MPI_Win_post(from, 0, win);
        MPI_Win_start(to, 0, win);
        MPI_Get(&got, 1, MPI_INT, next, LONG, 1, MPI_INT, win);
        MPI_Put(out, LONG, MPI_INT, next, 0, LONG, MPI_INT, win);
        MPI_Win_complete(win);
        if (round == 1)
            MPI_Sendrecv(&got, 1, MPI_INT, next, 3, &told, 1, MPI_INT, before, 3, MPI_COMM_WORLD,
                         MPI_STATUS_IGNORE);
        MPI_Win_wait(win);
        holds = holds && got == 7 * next + round && (round < 1 || told == 7 * rank + 1);
        for (int i = 0; i < LONG; i++)
            holds = holds && memory[i] == 1000 * before + i + round;
    }
    /* The last rank accesses the first, which waits for its message in between. */
    if (size > 1 && rank == 0) {
        MPI_Win_post(from, 0, win);
        MPI_Recv(&told, 1, MPI_INT, before, 4, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        MPI_Win_wait(win);
        holds = holds && told == 2 && memory[5] == -size;
    } else if (size > 1 && rank == size - 1) {
        int value = -size;
        MPI_Win_start(to, 0, win);
        MPI_Get(&got, 1, MPI_INT, 0, LONG, 1, MPI_INT, win);
        MPI_Put(&value, 1, MPI_INT, 0, 5, 1, MPI_INT, win);
        MPI_Win_complete(win);
        MPI_Send(&got, 1, MPI_INT, 0, 4, MPI_COMM_WORLD);
    }
    MPI_Win_free(&win);
    MPI_Group_free(&to);
    MPI_Group_free(&from);
    MPI_Group_free(&world);
    all("each accesses the next, and is accessed meanwhile", holds);
}

/* Rank 0 computes, and takes part in nothing: the others count in its memory, and each takes its turn. */
static void lock(void)
{
    enum { ROUNDS = 20, LONG = 10000 };
    static int long_out[LONG], long_in[LONG];
    int *memory, one = 1, before, sum = 0, holds = 1, expected, seen;
    double begin = MPI_Wtime();
    MPI_Win win;
    MPI_Win_allocate((LONG + 4) * (MPI_Aint)sizeof(int), sizeof(int), MPI_INFO_NULL, MPI_COMM_WORLD, &memory,
                     &win);
    MPI_Win_lock(MPI_LOCK_EXCLUSIVE, rank, 0, win);
    memset(memory, 0, (LONG + 4) * sizeof(int));
    MPI_Win_unlock(rank, win);
    MPI_Barrier(MPI_COMM_WORLD);
    while (rank == 0 && MPI_Wtime() - begin < 1)
        continue;
    for (int i = 0; rank > 0 && i < ROUNDS; i++) {
        MPI_Win_lock(MPI_LOCK_EXCLUSIVE, 0, 0, win); /* read, add and write without the others */
        MPI_Get(&before, 1, MPI_INT, 0, 0, 1, MPI_INT, win);
        MPI_Win_flush(0, win);
        before++;
        MPI_Put(&before, 1, MPI_INT, 0, 0, 1, MPI_INT, win);
        MPI_Win_unlock(0, win);
        MPI_Win_lock(MPI_LOCK_SHARED, 0, 0, win);
        MPI_Fetch_and_op(&one, &before, MPI_INT, 0, 1, MPI_SUM, win);
        MPI_Win_unlock(0, win);
        sum += before;
    }
    if (rank > 0)
        holds = size == 1 || MPI_Wtime() - begin < 1; /* rank 0 has not been waited for */
    MPI_Barrier(MPI_COMM_WORLD);
    int count = ROUNDS * (size - 1);
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    holds = holds && sum == count * (count - 1) / 2;
    MPI_Win_lock_all(0, win);
    MPI_Get(&before, 1, MPI_INT, 0, 0, 1, MPI_INT, win);
    MPI_Win_flush_all(win);
    holds = holds && before == count;
    expected = 0, seen = -1; /* the first that comes has it */
    int mine = rank + 1;
    MPI_Compare_and_swap(&mine, &expected, &seen, MPI_INT, 0, 2, win);
    MPI_Win_flush(0, win);
    MPI_Win_unlock_all(win);
    int first = seen == 0, firsts;
    MPI_Allreduce(&first, &firsts, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    holds = holds && firsts == 1 && (first || (seen >= 1 && seen <= size));
    /* More than a message of the handler's has. */
    int next = (rank + 1) % size;
    for (int i = 0; i < LONG; i++)
        long_out[i] = rank + i;
    MPI_Win_lock(MPI_LOCK_EXCLUSIVE, next, 0, win);
    MPI_Accumulate(long_out, LONG, MPI_INT, next, 4, LONG, MPI_INT, MPI_SUM, win);
    MPI_Get(long_in, LONG, MPI_INT, next, 4, LONG, MPI_INT, win);
    MPI_Win_unlock(next, win);
    for (int i = 0; i < LONG; i++)
        holds = holds && long_in[i] == rank + i;
    MPI_Win_free(&win);
    all("locks: the target computes meanwhile", holds);
}

static int handled;
static void on_error(MPI_Win *win, int *code, ...)
{
    (void)win;
    handled = *code;
}

static void known(void)
{
    int memory[10], *base, *unit, *flavor, flag, x = 0, holds = 1, members;
    MPI_Aint *bytes;
    MPI_Win win;
    MPI_Group group;
    MPI_Errhandler handler;
    MPI_Win_create(memory, sizeof memory, 4, MPI_INFO_NULL, MPI_COMM_WORLD, &win);
    MPI_Win_get_attr(win, MPI_WIN_BASE, &base, &flag);
    holds = flag && base == memory;
    MPI_Win_get_attr(win, MPI_WIN_SIZE, &bytes, &flag);
    MPI_Win_get_attr(win, MPI_WIN_DISP_UNIT, &unit, &flag);
    MPI_Win_get_attr(win, MPI_WIN_CREATE_FLAVOR, &flavor, &flag);
    holds = holds && *bytes == sizeof memory && *unit == 4 && *flavor == MPI_WIN_FLAVOR_CREATE;
    MPI_Win_get_group(win, &group);
    MPI_Group_size(group, &members);
    MPI_Group_free(&group);
    MPI_Win_create_errhandler(on_error, &handler);
    MPI_Win_set_errhandler(win, handler);
    MPI_Errhandler_free(&handler);
    holds = holds && members == size && MPI_Put(&x, 1, MPI_INT, 0, 0, 1, MPI_INT, win) == MPI_ERR_RMA_SYNC;
    MPI_Win_fence(0, win);
    MPI_Put(&x, 1, MPI_INT, 0, 10, 1, MPI_INT, win);
    holds = holds && handled == MPI_ERR_RMA_RANGE;
    holds = holds && MPI_Put(&x, 1, MPI_INT, size, 0, 1, MPI_INT, win) == MPI_ERR_RANK;
    MPI_Win_fence(0, win);
    MPI_Win_free(&win);
    all("what is known of a window, and errors", holds);
}

int main(int argc, char **argv)
{
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    if (argc > 1) {
        int memory[2];
        MPI_Win win;
        MPI_Win_create(memory, sizeof memory, 4, MPI_INFO_NULL, MPI_COMM_WORLD, &win);
        MPI_Win_fence(0, win);
        MPI_Get(&rank, 1, MPI_INT, 1, 2, 1, MPI_INT, win);
    }
    fence();
    datatypes();
    post();
    ring();
    lock();
    known();
    if (rank == 0)
        printf("after %.9f s\n", MPI_Wtime());
    MPI_Finalize();
    return 0;
}
