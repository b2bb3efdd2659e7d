/* sleep.h - what a program waits for in sleep and usleep. */
#ifndef MPI_SLEEP_H
#define MPI_SLEEP_H
#include "backend_node.h"

/* For node_wait: has a time come, a double of seconds of mpi_seconds()? */
bool sleep_is_over(struct node *n, void *time);
#endif
