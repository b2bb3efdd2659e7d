/* idle.h - the yielding of processors while there is nothing to do. With more nodes than processors (mpirun
 * --oversubscribe, or mpi_yield_when_idle) Open MPI yields in each look at a request that is not complete. NX
 * looks in each call that receives or probes; if each yielded, other programs would have their time slices
 * before a call goes on that need not wait. So, after the beginning, MPI yields no more, and NX does where it
 * waits. */
#ifndef MPI_IDLE_H
#define MPI_IDLE_H
#include <sched.h>
#include <stdbool.h>

/* Is NX to yield in MPI's stead? */
extern bool idle_yields __attribute__((visibility("hidden")));

/* From now on NX yields; from now on MPI does again. */
void idle_begin(void);
void idle_end(void);

/* For loops that wait for another node's library, which is about to answer. */
static inline void idle_pause(void)
{
    if (idle_yields)
        sched_yield();
}
#endif
