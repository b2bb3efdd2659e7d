/* topologies.h - the grid or graph of a communicator. */
#ifndef MPI_TOPOLOGIES_H
#define MPI_TOPOLOGIES_H
#include "coll.h"

/* The communicator's, of this kind; NULL with *code: it has none. */
const struct topology *topology_of(int call, MPI_Comm comm, int kind, int *code);
struct topology *topology_of_neighbors(int ins, const int sources[], const int *in_weights, int outs,
                                       const int dests[], const int *out_weights);
/* A communicator of the first ranks, with a topology, which it takes over. */
int topology_make(const struct coll *o, int ranks, struct topology *t, MPI_Comm *to);
void topology_coords(const struct topology *t, int rank, int coords[]);
/* MPI_PROC_NULL: outside of a side that is not periodic. */
int topology_rank_at(const struct topology *t, const int coords[]);
#endif
