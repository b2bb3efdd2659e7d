/* launcher.c - see launcher.h. Launchers tell each process how many there are, by variables of their own. */
#include "nx_api/mpi/launcher.h"
#include <stdlib.h>

static const struct launcher {
    const char *variable, *name;
} launchers[] = {
    {"OMPI_COMM_WORLD_SIZE", "Open MPI's mpirun"},
    {"PMI_SIZE", "the mpirun of MPICH or one of its kind"},
    {"SLURM_STEP_NUM_TASKS", "srun"},
};

void launcher_check(struct node *n)
{
    for (size_t i = 0; n->sys->count == 1 && i < sizeof launchers / sizeof *launchers; i++) {
        const char *processes = getenv(launchers[i].variable);
        if (processes && atol(processes) > 1)
            node_fail(
                n,
                "%s has started %s processes, but the program's MPI knows only this one: start it with the "
                "mpirun (or srun --mpi=...) of the MPI that it is linked with, or link it with this one's "
                "mpicc (NXCC_MPICC)",
                launchers[i].name, processes);
    }
}
