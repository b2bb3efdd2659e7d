/* neighbor_names.c - Fortran's names for the collectives of neighbours on grids and graphs. */
#include "fortran.h"

#define NEIGHBOR(name, parameters, arguments)                                                                \
    FORTRAN(neighbor_##name, (LIST parameters, f_int * comm, f_int * ierr))                                  \
    {                                                                                                        \
        IERR = MPI_Neighbor_##name(LIST arguments, F_COMM(comm));                                            \
    }                                                                                                        \
    FORTRAN(ineighbor_##name, (LIST parameters, f_int * comm, f_int * request, f_int * ierr))                \
    {                                                                                                        \
        NEW(MPI_Request, request, MPI_Ineighbor_##name(LIST arguments, F_COMM(comm), &made));                \
    }
#define LIST(...) __VA_ARGS__
#define FROM void *buf, f_int *count, f_int *type
#define GIVES buf, *count, F_TYPE(type)
#define INTO void *into, f_int *room, f_int *as
#define GETS into, *room, F_TYPE(as)
#define INTO_EACH void *into, f_int *rooms, f_int *places, f_int *as
#define GETS_EACH into, rooms, places, F_TYPE(as)

NEIGHBOR(allgather, (FROM, INTO), (GIVES, GETS))
NEIGHBOR(allgatherv, (FROM, INTO_EACH), (GIVES, GETS_EACH))
NEIGHBOR(alltoall, (FROM, INTO), (GIVES, GETS))
NEIGHBOR(alltoallv, (void *buf, f_int *counts, f_int *at, f_int *type, INTO_EACH),
         (buf, counts, at, F_TYPE(type), GETS_EACH))

/* The neighbours that send to the rank, and receive from it. (What has none is for the call to refuse.) */
static void count_neighbors(MPI_Comm comm, int *ins, int *outs)
{
    const struct comm *c = comm_of(comm);
    const struct topology *t = c ? c->topology : NULL;
    *ins = *outs = 0;
    if (t && t->kind == MPI_CART)
        *ins = *outs = 2 * t->dims;
    else if (t && t->kind == MPI_GRAPH)
        MPI_Graph_neighbors_count(comm, c->local->rank, ins), *outs = *ins;
    else if (t)
        *ins = t->edge_count, *outs = t->outs;
}

#define EACH                                                                                                 \
    void *buf, f_int *counts, MPI_Aint *at, f_int *types, void *into, f_int *rooms, MPI_Aint *places,        \
        f_int *as, f_int *comm
#define GIVE_EACH buf, counts, at, list, into, rooms, places, list + outs, F_COMM(comm)

FORTRAN(neighbor_alltoallw, (EACH, f_int *ierr))
{
    int ins, outs;
    count_neighbors(F_COMM(comm), &ins, &outs);
    MPI_Datatype *list = f_both_types(types, outs, as, ins);
    IERR = MPI_Neighbor_alltoallw(GIVE_EACH);
    free(list);
}

FORTRAN(ineighbor_alltoallw, (EACH, f_int *request, f_int *ierr))
{
    int ins, outs;
    count_neighbors(F_COMM(comm), &ins, &outs);
    MPI_Datatype *list = f_both_types(types, outs, as, ins);
    NEW_WITH_LIST(request, list, MPI_Ineighbor_alltoallw(GIVE_EACH, &made));
}
