/* files.h - the files that a process has open by number, and their I/O modes. Files of all kinds are the host's own.
 *
 * Modes 1 to 4 share a pointer among the nodes; messages between the libraries keep it (shared.h). A file gets its mode on
 * all nodes, by gopen or by setiomode called in the same order everywhere: so the nodes agree which pointer is meant. */
#ifndef MPI_FILES_H
#define MPI_FILES_H
#include <stdint.h>
#include <sys/uio.h>
#include "backend_node.h"

struct open_file {
    char *path;      /* as the program named it; NULL: not opened by open() or its kin */
    int mode;        /* M_UNIX to M_ASYNC */
    int32_t pointer; /* which of the shared ones, but in M_UNIX and M_ASYNC */
    int64_t next;    /* M_RECORD: where the next round begins */
    int64_t round;
};

/* What is known of an open file; NULL if it is not open. It stays where it is until the next call of these. */
struct open_file *files_find(int fd);
void files_opened(int fd, const char *path);
#endif
