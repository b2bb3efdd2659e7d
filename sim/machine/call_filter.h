/* call_filter.h - has the kernel refuse system calls of node programs.
 *
 * Programs reach this computer only by the functions that the simulator gives them (guest/exports.def). But
 * they are native code, and could execute the instruction of a system call themselves. The kernel tells a
 * filter (seccomp) at which address the instruction is: where programs lie, the simulator has none. The
 * filter also refuses to start other programs, wherever the call comes from. */
#ifndef MACHINE_CALL_FILTER_H
#define MACHINE_CALL_FILTER_H
#include <stdbool.h>

/* For the calling thread, threads that it will make, and for good. A refused call gives SIGSYS (crash.h).
 * Returns false with errno if the kernel has no such filter, or has put the simulator's libraries where
 * programs lie. */
bool call_filter_install(void);
#endif
