/* mpi_kind.h - the MPI that a program for a cluster is linked with, and whether the two go together. */
#ifndef DRIVER_MPI_KIND_H
#define DRIVER_MPI_KIND_H
#include "nx_api/driver/places.h"

/* The MPI's compiler driver: what NXCC_MPICC names, or mpicc. Does not return if there is none. */
const char *mpi_command(void);
/* The folder of the libraries for that MPI. Does not return if nxcc has not been built for its kind. */
const char *mpi_folder(const struct places *p);
/* Does not return if a linked program has functions of its own by names that libnx.a calls MPI by: says
 * which, and removes the program. Warns if the program begins MPI, which NX has done. */
void mpi_check_names(const struct places *p, const char *program);

#endif
