/* paths.h - where the files under /cfs, or /pfs, which is the same, are: in the folder that TOUCHSTONE_CFS names, or else in ./cfs. All nodes are to see
 * the same folder: on several machines, one on a shared file system. */
#ifndef MPI_PATHS_H
#define MPI_PATHS_H
#include <limits.h>
#include <stdbool.h>

bool path_is_cfs(const char *path);
/* The file's name on this machine, written into space or path itself. NULL with errno: "..", which leads out of /cfs
 * (EACCES), or too long. */
const char *path_here(const char *path, char space[PATH_MAX]);
/* As open(), and the file is known to files.h. */
int path_open(const char *path, int flags, unsigned mode);
/* Makes the folders that lead to it, as the Concurrent File System needs none. */
void path_make_folders(const char *here);
#endif
