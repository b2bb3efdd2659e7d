/* waits_in_windows.h - what waits and messages of MPI's windows are about, read from the programs' memory:
 * MPI's library makes them of messages, which say little of that. */
#ifndef MACHINE_WAITS_IN_WINDOWS_H
#define MACHINE_WAITS_IN_WINDOWS_H
#include "node/system.h"
#include "nx_api/waitfor/waitfor.h"

/* Adds to a graph that is filled in, and not analysed: which process types are windows', who has the locks
 * that are waited for, and who has to complete, if there is only one. */
void waits_in_windows(const struct node_system *s, struct waitfor *w);
#endif
