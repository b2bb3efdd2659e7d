/* mpi_win_stuck.c - ranks that wait in calls for a window for a rank that does not come, as the argument
 * says. */
#include <mpi.h>
#include <string.h>

int main(int argc, char **argv)
{
    int rank, size, memory = 0, x = 1;
    MPI_Win win;
    MPI_Group world, other;
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    MPI_Win_create(&memory, sizeof memory, sizeof memory, MPI_INFO_NULL, MPI_COMM_WORLD, &win);
    MPI_Comm_group(MPI_COMM_WORLD, &world);
    MPI_Group_incl(world, 1, (int[]){rank ^ 1}, &other);
    const char *how = argv[1];
    if (strcmp(how, "start") == 0)
        MPI_Win_set_name(win, "halo");
    if (strcmp(how, "fence") == 0 && rank > 0)
        MPI_Win_fence(0, win);
    if (strcmp(how, "start") == 0 && rank == 0)
        MPI_Win_start(other, 0, win);
    if (strcmp(how, "wait") == 0 && rank == 0) {
        MPI_Win_post(other, 0, win);
        MPI_Win_wait(win);
    }
    if (strcmp(how, "lock") == 0 && rank == 0) {
        MPI_Win_lock(MPI_LOCK_EXCLUSIVE, 1, 0, win);
        MPI_Recv(&x, 1, MPI_INT, 1, 5, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    }
    if (strcmp(how, "lock") == 0 && rank > 0) {
        MPI_Win_lock(MPI_LOCK_EXCLUSIVE, 1, 0, win);
        MPI_Send(&x, 1, MPI_INT, 0, 5, MPI_COMM_WORLD);
        MPI_Win_unlock(1, win);
    }
    if (strcmp(how, "cross") == 0) {
        MPI_Win_lock(MPI_LOCK_EXCLUSIVE, rank, 0, win);
        MPI_Win_lock(MPI_LOCK_EXCLUSIVE, (rank + 1) % size, 0, win);
    }
    if (strcmp(how, "starts") == 0)
        MPI_Win_start(other, 0, win);
    if (strcmp(how, "waits") == 0) {
        MPI_Win_post(other, 0, win);
        MPI_Win_wait(win);
    }
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_Finalize();
    return 0;
}
