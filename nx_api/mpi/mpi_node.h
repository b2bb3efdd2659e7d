/* mpi_node.h - a process's beginning, end and time. */
#ifndef MPI_NODE_H
#define MPI_NODE_H
#include "backend_node.h"

/* Bytes of a program's long: 8, or 4 (nxcc --long32). */
extern int mpi_long_bytes;

/* Ends this process as if it were killed: its output is written. */
_Noreturn void mpi_end_here(struct node *n);
/* Seconds since the program began. */
double mpi_seconds(void);
#endif
