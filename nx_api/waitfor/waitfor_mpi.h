/* waitfor_mpi.h - MPI's words for messages: their type is a tag, or the number of a collective on its
 * communicator, and their process type says which communicator (mpi_api/core/core.h). */
#ifndef WAITFOR_MPI_H
#define WAITFOR_MPI_H
#include <stdbool.h>
#include <stdio.h>

/* Is it the process type of MPI's messages? */
bool waitfor_is_mpi(long pid);
/* What such messages call their type: "tag", or "collective". */
const char *waitfor_mpi_type(long pid);
/* Is the wait, in a window, one for the target's answer, as to a lock? */
struct waitfor_select;
bool waitfor_is_answer(const struct waitfor_select *s);
/* "MPI_COMM_WORLD", "communicator 3", by the process type of its messages. */
void waitfor_print_communicator(FILE *f, long context);
#endif
