/* idle.c - see idle.h. Open MPI has a parameter for this (mpi_yield_when_idle), but reads it only once; later
 * it is set by a function of its library libopen-pal. Another MPI has none. */
#include "nx_api/mpi/idle.h"
#include <dlfcn.h>

/* Returns what was set before. */
typedef bool set_yield(bool yield);

bool idle_yields;

static bool set(bool yield)
{
    set_yield *set_mpi = (set_yield *)dlsym(RTLD_DEFAULT, "opal_progress_set_yield_when_idle");
    return set_mpi && set_mpi(yield);
}

void idle_begin(void)
{
    idle_yields = set(false);
}

void idle_end(void)
{
    set(idle_yields);
}
