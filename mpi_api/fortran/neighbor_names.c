/* neighbor_names.c - Fortran's names for the collectives of neighbours on grids and graphs. */
#include "fortran.h"

#define NEIGHBOR(name, parameters, arguments)                                                                \
    FORTRAN(neighbor_##name, (LIST parameters, f_int * comm, f_int * ierr))                                  \
    {                                                                                                        \
        *ierr = MPI_Neighbor_##name(LIST arguments, F_COMM(comm));                                           \
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
