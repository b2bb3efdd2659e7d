/* mpi_findings.h - what is wrong with a run's calls of MPI: by kind and by place in the source, however often
 * and on however many nodes. */
#ifndef MPI_FINDINGS_H
#define MPI_FINDINGS_H
#include <stdbool.h>
#include <stdio.h>
#include "mpi_api/core/told.h"

struct node;
struct node_image;

/* A call in the source: the return address, and those around it, since Fortran's bindings come first. */
enum { MPI_FRAMES = 3 };
struct mpi_place {
    const char *call; /* "MPI_Irecv"; NULL: none */
    const struct node_image *file;
    uint32_t at[MPI_FRAMES]; /* offsets from the program's beginning; 0: none */
};
struct mpi_place mpi_place(const struct node *n, const struct nxm_told *c);

enum mpi_finding {
    PENDING_REQUESTS,
    KEPT_REQUESTS,
    UNRECEIVED,
    TOO_LONG,
    KEPT_COMMS,
    KEPT_TYPES,
    KEPT_GROUPS,
    KEPT_OPS,
    OTHER_CALLS,
    OTHER_ROOTS,
    OTHER_OPS,
    OTHER_AMOUNTS,
    OTHER_TYPES,
    ONE_MEMORY,
    NOT_FINALIZED,
    MPI_FINDINGS
};

struct mpi_findings;
struct mpi_findings *mpi_findings_new(void);
void mpi_findings_free(struct mpi_findings *all);
/* Something is wrong with what the call at `place` did on a node, and with another (NULL: none). `detail` is
 * what is known of the first instance. */
void mpi_findings_add(struct mpi_findings *all, enum mpi_finding kind, uint32_t node,
                      const struct mpi_place *place, const struct mpi_place *other, const char *detail);
/* A line for each kind and place, whoever called it, each behind `before`. False: there are none. Once. */
bool mpi_findings_print(struct mpi_findings *all, const char *before, FILE *f);
#endif
