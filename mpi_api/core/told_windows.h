/* told_windows.h - the windows of an MPI program that stands still, for reports: told.h says when they may be
 * read. */
#ifndef MPI_TOLD_WINDOWS_H
#define MPI_TOLD_WINDOWS_H
#include "mpi_api/core/library.h"

/* The window whose messages have this process type; NULL: they are not a window's. */
const struct win *told_window(const struct nxm_library *l, long pid);
/* The node of a rank of a group. */
int told_node(const struct group *g, int rank);
/* Has the program locked its window's memory on a node? */
bool told_locks(const struct win *w, int node);
#endif
