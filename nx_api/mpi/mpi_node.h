/* mpi_node.h - a process's beginning and time. */
#ifndef MPI_NODE_H
#define MPI_NODE_H
#include "backend_node.h"

/* Bytes of a program's long: 8, or 4 (nxcc --long32). */
extern int mpi_long_bytes;

/* Seconds since the program began. */
double mpi_seconds(void);
#endif
