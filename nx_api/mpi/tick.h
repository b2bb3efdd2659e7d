/* tick.h - the clock that makes a computing program take in its messages, if no sender rings for them
 * (bells.h).
 *
 * nxcc --mpi puts a poll into each loop and function (nxcc/counting/poll.cc), which calls nxc_preempt when
 * nxc_due is not 0. A second thread sleeps and sets nxc_due, and does nothing else: it calls no MPI and takes
 * no lock. */
#ifndef MPI_TICK_H
#define MPI_TICK_H
#include <stdbool.h>

/* The bounds of the code that a poll of the program calls. */
extern const char nxc_enter[];
extern const char nxc_enter_end[] __attribute__((visibility("hidden")));

/* Start the thread; false and errno when there is no room for one. `rung`: whether all senders ring. */
bool tick_start(bool rung);
/* Whether handlers are posted. Then tick every 0.2 ms, or every 0.03 ms if not all senders ring; else every
 * 2 ms, so that long messages proceed. */
void tick_often(bool often);
/* Whether the program waits in a call, and polls without ticks. */
void tick_rest(bool rest);
#endif
