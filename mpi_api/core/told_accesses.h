/* told_accesses.h - the memory that a call of MPI reads or writes. */
#ifndef MPI_TOLD_ACCESSES_H
#define MPI_TOLD_ACCESSES_H
#include "mpi_api/core/told.h"

/* Memory that a call reads or writes, or may until its request is done. `exact`: all of it; else as much as a
 * message has that comes. */
struct told_access {
    uintptr_t at;
    size_t bytes;
    bool write, exact;
};
typedef void told_access_fn(void *ctx, const struct told_access *a);
/* Tells of each stretch; of datatypes of many pieces, of the first 1,000. */
void told_accesses(const struct nxm_library *l, const struct nxm_told *c, told_access_fn *f, void *ctx);
/* Tells of each stretch of a send or receive that is under way. */
void told_request_accesses(const struct nxm_library *l, const struct request *r, told_access_fn *f,
                           void *ctx);
#endif
