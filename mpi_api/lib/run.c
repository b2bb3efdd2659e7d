/* run.c - the beginning and the end, and what programs ask of their surroundings. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "coll.h"
#include "nx.h"

READ_OFTEN bool mpi_runs;
READ_OFTEN long mpi_eager_limit;
bool mpi_of_1995;
static bool has_run;
static int threads = MPI_THREAD_SINGLE;
READ_OFTEN static struct group world_group;
static struct group self_group;

struct comm comm_world = {.local = &world_group, .peers = &world_group};
struct comm comm_self = {.local = &self_group, .peers = &self_group};

static void set_group(struct group *g, int size, int rank, int first)
{
    *g = (struct group){.object = {GROUP, 1, 0}, .size = size, .rank = rank, .first = first};
}

void run_begin(void)
{
    set_group(&world_group, (int)numnodes(), (int)mynode(), 0);
    set_group(&self_group, 1, 0, (int)mynode());
    comm_world.context = NXM_FIRST_CONTEXT, comm_self.context = NXM_FIRST_CONTEXT + 2;
    comm_world.handler = comm_self.handler = MPI_ERRORS_ARE_FATAL;
    comm_world.object = comm_self.object = (struct object){COMM, 1, 0};
    mpi_eager_limit = nxm_number(NXM_EAGER_LIMIT);
    mpi_of_1995 = nxm_number(NXM_COLLECTIVES) == 1995;
    mpi_runs = true;
}

static int init(int call)
{
    if (mpi_runs || has_run)
        return fail(NULL, call, MPI_ERR_OTHER, "called a second time");
    run_begin();
    return MPI_SUCCESS;
}

CALL(Init, (int *argc, char ***argv))
{
    (void)argc, (void)argv;
    return init(CALL_Init);
}

CALL(Init_thread, (int *argc, char ***argv, int required, int *provided))
{
    (void)argc, (void)argv;
    threads = required < MPI_THREAD_FUNNELED ? MPI_THREAD_SINGLE : MPI_THREAD_FUNNELED;
    *provided = threads;
    return init(CALL_Init_thread);
}

CALL(Initialized, (int *flag))
{
    *flag = mpi_runs || has_run;
    return MPI_SUCCESS;
}

CALL(Finalize, (void))
{
    if (!mpi_runs)
        return fail_comm(CALL_Finalize);
    comm_delete_attributes(&comm_self);
    const struct coll all = coll_of(&comm_world, CALL_Finalize);
    coll_barrier(&all);
    mpi_runs = false, has_run = true;
    return MPI_SUCCESS;
}

CALL(Finalized, (int *flag))
{
    *flag = has_run;
    return MPI_SUCCESS;
}

CALL(Abort, (MPI_Comm comm, int code))
{
    char text[80];
    (void)comm;
    snprintf(text, sizeof text, "the program ends the run, with code %d", code);
    nxm_fail(CALL_Abort, text);
    return MPI_SUCCESS;
}

CALL(Query_thread, (int *provided))
{
    *provided = threads;
    return MPI_SUCCESS;
}

CALL(Is_thread_main, (int *flag))
{
    *flag = 1;
    return MPI_SUCCESS;
}

CALL(Get_processor_name, (char *name, int *length))
{
    *length = snprintf(name, MPI_MAX_PROCESSOR_NAME, "node %ld", mynode());
    return MPI_SUCCESS;
}

CALL(Get_version, (int *version, int *subversion))
{
    *version = MPI_VERSION, *subversion = MPI_SUBVERSION;
    return MPI_SUCCESS;
}

CALL(Get_library_version, (char *version, int *length))
{
    *length = snprintf(version, MPI_MAX_LIBRARY_VERSION_STRING, "touchstone, on simulated nodes");
    return MPI_SUCCESS;
}

CALL(Pcontrol, (const int level, ...))
{
    (void)level;
    return MPI_SUCCESS;
}

CALL(Alloc_mem, (MPI_Aint size, MPI_Info info, void *base))
{
    (void)info;
    if (size < 0)
        return fail(NULL, CALL_Alloc_mem, MPI_ERR_ARG, "%ld bytes", (long)size);
    void *p = malloc((size_t)size + !size);
    if (!p)
        return fail(NULL, CALL_Alloc_mem, MPI_ERR_NO_MEM, "no memory for %ld bytes", (long)size);
    memcpy(base, &p, sizeof p);
    return MPI_SUCCESS;
}

CALL(Free_mem, (void *base))
{
    free(base);
    return MPI_SUCCESS;
}

double PMPI_Wtime(void)
{
    return dclock();
}

/* A clock of the node's processor, or better: the simulator's clock has picoseconds. */
double PMPI_Wtick(void)
{
    return 1e-7;
}

double MPI_Wtime(void) __attribute__((weak, alias("PMPI_Wtime")));
double MPI_Wtick(void) __attribute__((weak, alias("PMPI_Wtick")));

MPI_Aint PMPI_Aint_add(MPI_Aint base, MPI_Aint displacement)
{
    return base + displacement;
}

MPI_Aint PMPI_Aint_diff(MPI_Aint a, MPI_Aint b)
{
    return a - b;
}

MPI_Aint MPI_Aint_add(MPI_Aint base, MPI_Aint displacement) __attribute__((weak, alias("PMPI_Aint_add")));
MPI_Aint MPI_Aint_diff(MPI_Aint a, MPI_Aint b) __attribute__((weak, alias("PMPI_Aint_diff")));
