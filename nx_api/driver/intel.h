/* intel.h - what makefiles of the time give to icc and if77, the compilers that Intel sold for the i860, and
 * their names. */
#ifndef DRIVER_INTEL_H
#define DRIVER_INTEL_H
#include <stdbool.h>
#include "nx_api/driver/arguments.h"

/* Takes an option of icc or if77: adds what GCC has for it, or notes that it is ignored. False: it is none
 * of theirs. */
bool intel_take(struct arguments *a, const char *option);

/* Says once, on standard error, which options were ignored. */
void intel_note(const struct arguments *a);

/* Makes the folder, if there is none, and in it links by the names of Intel's tools: icc, if77, ar860,
 * as860, nm860, size860, strip860; and cc and f77. Does not return. */
_Noreturn void intel_links(const char *folder);

/* Is nxcc called as the C compiler of a makefile of the time? */
bool intel_is_c_name(void);

/* Is nxcc called by a name of MPI's compilers; of those for C++? Makes links by these names: mpicc, mpif77,
 * mpif90, mpifort, mpicxx, mpic++, mpiCC. */
bool intel_is_mpi_name(void);
bool intel_is_cplusplus_name(void);
_Noreturn void intel_mpi_links(const char *folder);

/* If the option asks which compiler and options are behind mpicc, as build systems do (CMake's FindMPI),
 * answers that it is mpicc itself, with the folders of MPI's headers and library, and does not return. */
void intel_mpi_answer(const char *option);

/* Called as ar860, does what that did; as as860, says why it cannot be had. Returns if called by another
 * name. */
void intel_become_tool(char **argv);

#endif
