/* mpi_paths.h - names of files under /cfs, for which /pfs is another name: they lie in the folder that
 * TOUCHSTONE_CFS names, or else in ./cfs. All nodes have to see the same folder: several machines need a
 * shared file system. */
#ifndef MPI_PATHS_H
#define MPI_PATHS_H
#include <limits.h>
#include <stdbool.h>

bool path_is_cfs(const char *path);
/* The file's name on this machine: in space, or path itself. NULL with errno: the path has ".." (EACCES),
 * which could lead out of /cfs, is too long, or NULL itself. */
const char *path_here(const char *path, char space[PATH_MAX]);
/* As open(); enters the file into mpi_files.h's table. */
int path_open(const char *path, int flags, unsigned mode);
/* Makes the folders of a file's name: the Concurrent File System has none, and programs make none. */
void path_make_folders(const char *here);
#endif
