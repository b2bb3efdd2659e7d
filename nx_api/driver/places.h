/* places.h - the search for what nxcc needs: from where it is itself.
 *
 * in the build tree   BUILD/nxcc
 *                     BUILD/node/{count.so, runtime.o, libnx.a ...}, BUILD/node/{include, cpu, mpi_include}
 * installed           PREFIX/bin/nxcc
 *                     PREFIX/lib/touchstone/{count.so ...},
 *                     PREFIX/share/touchstone/{include, cpu, mpi_include}
 */
#ifndef DRIVER_PLACES_H
#define DRIVER_PLACES_H
#include <stdbool.h>

struct places {
    char *lib;         /* count.so, runtime.o, libnx.a, libnode.so and the stand-ins for -lm, -lc, -lz */
    char *include;     /* nx.h */
    char *cpu;         /* i860.cfg */
    char *mpi_include; /* mpi.h */
};

/* The path of nxcc itself, and the folder that it is in; for free(). */
char *places_self(void);
char *places_folder(void);
struct places places_find(void);
/* Is that file MPI's library for simulated nodes? (CMake names it instead of -lmpi.) */
bool places_is_mpi_library(const char *file);
/* The whole path of a file of costs, for free(): a name without / may be one in cpu, too. */
char *places_costs(const struct places *p, const char *name);

#endif
