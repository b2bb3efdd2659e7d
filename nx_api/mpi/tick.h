/* tick.h - the clock that makes a computing program look at its messages.
 *
 * nxcc --mpi puts a check into each loop and function (nxcc/poll.cc): it calls nxc_preempt when nxc_due is not 0. A thread
 * of its own does nothing but sleep and set nxc_due; it calls no MPI and takes no lock. */
#ifndef MPI_TICK_H
#define MPI_TICK_H
#include <stdbool.h>

extern volatile int nxc_due;

/* Start the thread; false and errno when there is no room for one. */
bool tick_start(void);
/* Handlers are posted: tick every 0.2 ms, else every 2 ms, so that long messages get on. */
void tick_often(bool often);
/* While the program waits in a call, it looks by itself. */
void tick_rest(bool rest);
#endif
