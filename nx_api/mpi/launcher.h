/* launcher.h - the check of whether the program was started by the MPI that it is linked with. */
#ifndef MPI_LAUNCHER_H
#define MPI_LAUNCHER_H
#include "backend_node.h"

/* Ends the process with a message if not: it would run as many programs of one node each. */
void launcher_check(struct node *n);
#endif
