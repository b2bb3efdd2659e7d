/* leftovers.h - what a rank makes, and has not freed or completed when it calls MPI_Finalize, or ends without
 * doing so: requests, communicators, datatypes, groups, operations. */
#ifndef MPI_LEFTOVERS_H
#define MPI_LEFTOVERS_H
#include "mpi_api/checks/mpi_findings.h"

struct made {
    struct mpi_place place;
    uintptr_t handle;
    enum kind kind;
};

/* Of one node; all 0 at first. */
struct leftovers {
    const struct nxm_library *library;
    struct made *list;
    size_t count, room;
    struct mpi_place init; /* MPI_Init's; no call: MPI_Finalize has been called, too */
    bool late;             /* attributes of MPI_COMM_SELF may free objects yet, in MPI_Finalize */
};

/* A call begins, which may be MPI_Finalize; has ended. It may be one inside another call, by a function that
 * the library has called. */
void leftovers_begin(struct leftovers *k, struct mpi_findings *all, struct node *n, const struct nxm_told *c);
void leftovers_end(struct leftovers *k, struct mpi_findings *all, struct node *n, const struct nxm_told *c);
/* The program has ended by itself. */
void leftovers_ended(struct leftovers *k, struct mpi_findings *all, const struct node *n);
void leftovers_free(struct leftovers *k);
#endif
