/* cluster.h - what is different in a program for a cluster (--mpi): nothing is counted, but loops and
 * functions check whether a handler is due; and MPI's compiler driver links. */
#ifndef DRIVER_CLUSTER_H
#define DRIVER_CLUSTER_H
#include "nx_api/driver/arguments.h"
#include "nx_api/driver/places.h"

const char *cluster_program(bool link);
void cluster_add_compile(struct arguments *a, const struct places *p);
void cluster_add_link(struct arguments *a, const struct places *p);

#endif
