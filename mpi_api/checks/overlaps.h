/* overlaps.h - the check of whether a call sends from memory that it receives in. MPI forbids that but where
 * a call says so: MPI_IN_PLACE, MPI_Sendrecv_replace. Some such calls are errors anyway (coll.h); others go
 * on. */
#ifndef MPI_OVERLAPS_H
#define MPI_OVERLAPS_H
#include "mpi_api/checks/mpi_findings.h"

/* A call begins. */
void overlaps_begin(struct mpi_findings *all, struct node *n, const struct nxm_told *c,
                    const struct nxm_library *l);
#endif
