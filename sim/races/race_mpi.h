/* race_mpi.h - buffers under way by MPI's calls: from the call that begins a request, as MPI_Isend or
 * MPI_Start, until the request is done for the program, as by MPI_Wait. What the library's own messages read
 * and write meanwhile (a collective's parts, pieces of a datatype packed together) is no concern of the
 * program's: so nothing else is told of a call of MPI (node_races.in_library). */
#ifndef RACES_RACE_MPI_H
#define RACES_RACE_MPI_H
#include "races/node_races.h"

extern const struct announcements race_mpi_observer;
#endif
