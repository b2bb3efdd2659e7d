/* mpi_end.h - a process's end: its program has returned, called exit, been killed, made an error, or
 * waits for ever.
 *
 * A process whose program has ended keeps taking messages in until all programs have ended: no send may
 * fail because its receiver was quick. */
#ifndef MPI_END_H
#define MPI_END_H
#include "backend_node.h"

/* Once, in the process itself. */
void mpi_end_begin(void);
/* Before a report at the end: its numbers are C's, whatever locale the program has set. */
void mpi_end_numbers(void);
/* Ends this process as if it were killed: its output is written. */
_Noreturn void mpi_end_here(struct node *n);
/* Ends all nodes, which wait for ever; node 0 has said why. */
_Noreturn void mpi_end_deadlocked(struct node *n);
#endif
