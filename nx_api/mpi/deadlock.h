/* deadlock.h - the report of a deadlock, and how often node 0 looks for one: waiting loops call
 * deadlock_look. */
#ifndef MPI_DEADLOCK_H
#define MPI_DEADLOCK_H
#include "backend_node.h"

/* As touchstone run. */
enum { DEADLOCK_STATUS = 2 };

/* For a loop that waits since then (seconds of mpi_seconds()) for what only messages can bring. If all
 * nodes do, for ever, node 0 writes the report, and this is true: the program is to be ended. */
bool deadlock_look(struct node *n, double since);
#endif
