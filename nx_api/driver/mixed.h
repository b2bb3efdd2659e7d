/* mixed.h - objects for simulated nodes and for a cluster in one program: after `make CC='nxcc --mpi'`, say,
 * with objects of an earlier make. */
#ifndef DRIVER_MIXED_H
#define DRIVER_MIXED_H
#include <stdbool.h>

/* Did the linker, in what it said, miss names that only the other kind of program has? Then says on standard
 * error which objects are of the other kind. mpi: the program is for a cluster. */
bool mixed_report(const char *said, bool mpi);

#endif
