/* mpi_files.h - a process's open files, by number, and their I/O modes.
 *
 * In modes 1 to 4 the nodes share a pointer, by messages between their libraries (shared_pointer.h). All
 * nodes give their files modes in the same order, by gopen or setiomode, so that the nodes agree on the
 * numbers of shared pointers. */
#ifndef MPI_FILES_H
#define MPI_FILES_H
#include <stdint.h>
#include <sys/uio.h>
#include "backend_node.h"

struct open_file {
    char *path;      /* as the program named it; NULL: opened by no call of libnx.a */
    int mode;        /* M_UNIX to M_ASYNC */
    int32_t pointer; /* the shared pointer's number; not in M_UNIX and M_ASYNC */
    int64_t next;    /* M_RECORD: where the next round begins */
    int64_t round;
};

/* An open file's entry, valid until the next call of either function; NULL: the file is not open. */
struct open_file *files_find(int fd);
void files_opened(int fd, const char *path);
/* Descriptor `to` is now open on the file of fd. A mode holds for both; rounds of M_RECORD and M_GLOBAL are
 * counted for each. */
void files_copied(int fd, int to);
/* For node_wait: is a job of io_jobs.h done? Time ends this wait, and no message. */
bool files_are_moved(struct node *n, void *job);
#endif
