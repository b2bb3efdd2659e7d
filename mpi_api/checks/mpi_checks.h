/* mpi_checks.h - what MPI programs do that the standard forbids, though the run goes on (touchstone run
 * --mpi-checks): requests, messages, communicators, datatypes, groups and operations that are left over at
 * MPI_Finalize, or that it is never called; collectives whose members do not fit together; messages received
 * as another kind of datatype than they were sent; memory that one call sends and receives in. It observes
 * the nodes (os/observer.h), and changes no virtual time. */
#ifndef MPI_CHECKS_H
#define MPI_CHECKS_H
#include <stdbool.h>
#include <stdio.h>
#include "node/system.h"

struct mpi_checks;

struct mpi_checks *mpi_checks_new(void);
void mpi_checks_free(struct mpi_checks *all);
/* Begins to check a node whose program has just been loaded. all NULL: checks nothing. */
void mpi_checks_begin(struct mpi_checks *all, struct node *n);
/* The program is gone. */
void mpi_checks_end(struct mpi_checks *all, struct node *n);
/* After the run, while the programs are there: a line for each kind and place, each behind `before`. False:
 * there is nothing to tell. */
bool mpi_checks_print(struct mpi_checks *all, const char *before, FILE *f);
#endif
