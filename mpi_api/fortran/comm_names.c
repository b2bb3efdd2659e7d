/* comm_names.c - Fortran's names for groups and communicators. */
#include "fortran.h"

/* --- groups --- */

FORTRAN(group_size, (f_int * group, f_int *size, f_int *ierr))
{
    IERR = MPI_Group_size(F_GROUP(group), size);
}

FORTRAN(group_rank, (f_int * group, f_int *rank, f_int *ierr))
{
    IERR = MPI_Group_rank(F_GROUP(group), rank);
}

FORTRAN(group_translate_ranks,
        (f_int * from, f_int *count, f_int *ranks, f_int *to, f_int *translated, f_int *ierr))
{
    IERR = MPI_Group_translate_ranks(F_GROUP(from), *count, ranks, F_GROUP(to), translated);
}

FORTRAN(group_compare, (f_int * a, f_int *b, f_int *result, f_int *ierr))
{
    IERR = MPI_Group_compare(F_GROUP(a), F_GROUP(b), result);
}

#define OF_TWO(name, c_name)                                                                                 \
    FORTRAN(name, (f_int * a, f_int * b, f_int * group, f_int * ierr))                                       \
    {                                                                                                        \
        NEW(MPI_Group, group, MPI_##c_name(F_GROUP(a), F_GROUP(b), &made));                                  \
    }
OF_TWO(group_union, Group_union)
OF_TWO(group_intersection, Group_intersection)
OF_TWO(group_difference, Group_difference)

FORTRAN(group_incl, (f_int * from, f_int *count, f_int *ranks, f_int *group, f_int *ierr))
{
    NEW(MPI_Group, group, MPI_Group_incl(F_GROUP(from), *count, ranks, &made));
}

FORTRAN(group_excl, (f_int * from, f_int *count, f_int *ranks, f_int *group, f_int *ierr))
{
    NEW(MPI_Group, group, MPI_Group_excl(F_GROUP(from), *count, ranks, &made));
}

FORTRAN(group_range_incl, (f_int * from, f_int *count, f_int ranges[][3], f_int *group, f_int *ierr))
{
    NEW(MPI_Group, group, MPI_Group_range_incl(F_GROUP(from), *count, ranges, &made));
}

FORTRAN(group_range_excl, (f_int * from, f_int *count, f_int ranges[][3], f_int *group, f_int *ierr))
{
    NEW(MPI_Group, group, MPI_Group_range_excl(F_GROUP(from), *count, ranges, &made));
}

FORTRAN(group_free, (f_int * group, f_int *ierr))
{
    WITH(MPI_Group, group, MPI_Group_free(&handle));
}

/* --- communicators --- */

#define ASK_COMM(name, c_name)                                                                               \
    FORTRAN(name, (f_int * comm, f_int * value, f_int * ierr))                                               \
    {                                                                                                        \
        IERR = MPI_##c_name(F_COMM(comm), value);                                                            \
    }
ASK_COMM(comm_size, Comm_size)
ASK_COMM(comm_rank, Comm_rank)
ASK_COMM(comm_test_inter, Comm_test_inter)
ASK_COMM(comm_remote_size, Comm_remote_size)
ASK_COMM(topo_test, Topo_test)
ASK_COMM(cartdim_get, Cartdim_get)

FORTRAN(comm_compare, (f_int * a, f_int *b, f_int *result, f_int *ierr))
{
    IERR = MPI_Comm_compare(F_COMM(a), F_COMM(b), result);
}

FORTRAN(comm_group, (f_int * comm, f_int *group, f_int *ierr))
{
    NEW(MPI_Group, group, MPI_Comm_group(F_COMM(comm), &made));
}

FORTRAN(comm_remote_group, (f_int * comm, f_int *group, f_int *ierr))
{
    NEW(MPI_Group, group, MPI_Comm_remote_group(F_COMM(comm), &made));
}

FORTRAN(comm_dup, (f_int * comm, f_int *to, f_int *ierr))
{
    NEW(MPI_Comm, to, MPI_Comm_dup(F_COMM(comm), &made));
}

FORTRAN(comm_dup_with_info, (f_int * comm, f_int *info, f_int *to, f_int *ierr))
{
    NEW(MPI_Comm, to, MPI_Comm_dup_with_info(F_COMM(comm), F_HANDLE(MPI_Info, *info), &made));
}

FORTRAN(comm_idup, (f_int * comm, f_int *to, f_int *request, f_int *ierr))
{
    MPI_Comm copy = MPI_COMM_NULL;
    NEW(MPI_Request, request, MPI_Comm_idup(F_COMM(comm), &copy, &made));
    *to = F_OF(copy);
}

FORTRAN(comm_idup_with_info, (f_int * comm, f_int *info, f_int *to, f_int *request, f_int *ierr))
{
    MPI_Comm copy = MPI_COMM_NULL;
    NEW(MPI_Request, request, MPI_Comm_idup_with_info(F_COMM(comm), F_HANDLE(MPI_Info, *info), &copy, &made));
    *to = F_OF(copy);
}

FORTRAN(comm_create_group, (f_int * comm, f_int *group, f_int *tag, f_int *to, f_int *ierr))
{
    NEW(MPI_Comm, to, MPI_Comm_create_group(F_COMM(comm), F_GROUP(group), *tag, &made));
}

FORTRAN(comm_create, (f_int * comm, f_int *group, f_int *to, f_int *ierr))
{
    NEW(MPI_Comm, to, MPI_Comm_create(F_COMM(comm), F_GROUP(group), &made));
}

FORTRAN(comm_split, (f_int * comm, f_int *color, f_int *key, f_int *to, f_int *ierr))
{
    NEW(MPI_Comm, to, MPI_Comm_split(F_COMM(comm), *color, *key, &made));
}

FORTRAN(comm_split_type, (f_int * comm, f_int *kind, f_int *key, f_int *info, f_int *to, f_int *ierr))
{
    NEW(MPI_Comm, to, MPI_Comm_split_type(F_COMM(comm), *kind, *key, F_HANDLE(MPI_Info, *info), &made));
}

FORTRAN(comm_free, (f_int * comm, f_int *ierr))
{
    WITH(MPI_Comm, comm, MPI_Comm_free(&handle));
}

FORTRAN(comm_disconnect, (f_int * comm, f_int *ierr))
{
    WITH(MPI_Comm, comm, MPI_Comm_disconnect(&handle));
}

FORTRAN(comm_get_parent, (f_int * parent, f_int *ierr))
{
    NEW(MPI_Comm, parent, MPI_Comm_get_parent(&made));
}

FORTRAN(comm_set_info, (f_int * comm, f_int *info, f_int *ierr))
{
    IERR = MPI_Comm_set_info(F_COMM(comm), F_HANDLE(MPI_Info, *info));
}

FORTRAN(comm_get_info, (f_int * comm, f_int *info, f_int *ierr))
{
    NEW(MPI_Info, info, MPI_Comm_get_info(F_COMM(comm), &made));
}

FORTRAN(intercomm_create,
        (f_int * local, f_int *leader, f_int *bridge, f_int *remote, f_int *tag, f_int *to, f_int *ierr))
{
    NEW(MPI_Comm, to, MPI_Intercomm_create(F_COMM(local), *leader, F_COMM(bridge), *remote, *tag, &made));
}

FORTRAN(intercomm_merge, (f_int * comm, f_int *high, f_int *to, f_int *ierr))
{
    NEW(MPI_Comm, to, MPI_Intercomm_merge(F_COMM(comm), *high, &made));
}

NAMES(comm, Comm, F_COMM)
