/* others.c - Fortran's names for all but messages: the run, datatypes, groups, communicators, topologies,
 * attributes and errors. */
#include "fortran.h"
#include <stdio.h>

/* --- the run --- */

FORTRAN(init, (f_int * ierr))
{
    *ierr = MPI_Init(NULL, NULL);
}

FORTRAN(init_thread, (f_int * required, f_int *provided, f_int *ierr))
{
    *ierr = MPI_Init_thread(NULL, NULL, *required, provided);
}

FORTRAN(finalize, (f_int * ierr))
{
    *ierr = MPI_Finalize();
}

FORTRAN(initialized, (f_int * flag, f_int *ierr))
{
    *ierr = MPI_Initialized(flag);
}

FORTRAN(finalized, (f_int * flag, f_int *ierr))
{
    *ierr = MPI_Finalized(flag);
}

FORTRAN(abort, (f_int * comm, f_int *code, f_int *ierr))
{
    *ierr = MPI_Abort(F_COMM(comm), *code);
}

FORTRAN(get_processor_name, (char *name, f_int *length, f_int *ierr, size_t room))
{
    char text[MPI_MAX_PROCESSOR_NAME];
    *ierr = MPI_Get_processor_name(text, length);
    f_give_text(name, room, text);
}

FORTRAN(get_version, (f_int * version, f_int *subversion, f_int *ierr))
{
    *ierr = MPI_Get_version(version, subversion);
}

FORTRAN(pcontrol, (f_int * level))
{
    (void)level;
}

double mpi_wtime_(void), mpi_wtick_(void);
double mpi_wtime_(void)
{
    return MPI_Wtime();
}

double mpi_wtick_(void)
{
    return MPI_Wtick();
}

/* --- datatypes --- */

#define NEW_TYPE(call)                                                                                       \
    do {                                                                                                     \
        MPI_Datatype made;                                                                                   \
        *ierr = (call);                                                                                      \
        if (!*ierr)                                                                                          \
            *type = F_OF(made);                                                                              \
    } while (0)

static MPI_Aint *addresses_of(const f_int *list, f_int count)
{
    MPI_Aint *a = get_memory(((size_t)count + 1) * sizeof *a);
    for (f_int i = 0; i < count; i++)
        a[i] = list[i];
    return a;
}

static MPI_Datatype *types_of(const f_int *list, f_int count)
{
    MPI_Datatype *t = get_memory(((size_t)count + 1) * sizeof *t);
    for (f_int i = 0; i < count; i++)
        t[i] = F_TYPE(&list[i]);
    return t;
}

FORTRAN(type_contiguous, (f_int * count, f_int *old, f_int *type, f_int *ierr))
{
    NEW_TYPE(MPI_Type_contiguous(*count, F_TYPE(old), &made));
}

FORTRAN(type_vector, (f_int * count, f_int *length, f_int *stride, f_int *old, f_int *type, f_int *ierr))
{
    NEW_TYPE(MPI_Type_vector(*count, *length, *stride, F_TYPE(old), &made));
}

FORTRAN(type_hvector, (f_int * count, f_int *length, f_int *stride, f_int *old, f_int *type, f_int *ierr))
{
    NEW_TYPE(MPI_Type_create_hvector(*count, *length, *stride, F_TYPE(old), &made));
}

FORTRAN(type_create_hvector,
        (f_int * count, f_int *length, MPI_Aint *stride, f_int *old, f_int *type, f_int *ierr))
{
    NEW_TYPE(MPI_Type_create_hvector(*count, *length, *stride, F_TYPE(old), &made));
}

FORTRAN(type_indexed, (f_int * count, f_int *lengths, f_int *at, f_int *old, f_int *type, f_int *ierr))
{
    NEW_TYPE(MPI_Type_indexed(*count, lengths, at, F_TYPE(old), &made));
}

FORTRAN(type_hindexed, (f_int * count, f_int *lengths, f_int *at, f_int *old, f_int *type, f_int *ierr))
{
    MPI_Aint *bytes = addresses_of(at, *count);
    NEW_TYPE(MPI_Type_create_hindexed(*count, lengths, bytes, F_TYPE(old), &made));
    free(bytes);
}

FORTRAN(type_create_hindexed,
        (f_int * count, f_int *lengths, MPI_Aint *at, f_int *old, f_int *type, f_int *ierr))
{
    NEW_TYPE(MPI_Type_create_hindexed(*count, lengths, at, F_TYPE(old), &made));
}

FORTRAN(type_create_indexed_block,
        (f_int * count, f_int *length, f_int *at, f_int *old, f_int *type, f_int *ierr))
{
    NEW_TYPE(MPI_Type_create_indexed_block(*count, *length, at, F_TYPE(old), &made));
}

FORTRAN(type_struct, (f_int * count, f_int *lengths, f_int *at, f_int *types, f_int *type, f_int *ierr))
{
    MPI_Aint *bytes = addresses_of(at, *count);
    MPI_Datatype *list = types_of(types, *count);
    NEW_TYPE(MPI_Type_create_struct(*count, lengths, bytes, list, &made));
    free(bytes);
    free(list);
}

FORTRAN(type_create_struct,
        (f_int * count, f_int *lengths, MPI_Aint *at, f_int *types, f_int *type, f_int *ierr))
{
    MPI_Datatype *list = types_of(types, *count);
    NEW_TYPE(MPI_Type_create_struct(*count, lengths, at, list, &made));
    free(list);
}

FORTRAN(type_create_subarray, (f_int * dims, f_int *sizes, f_int *subsizes, f_int *starts, f_int *order,
                               f_int *old, f_int *type, f_int *ierr))
{
    NEW_TYPE(MPI_Type_create_subarray(*dims, sizes, subsizes, starts, *order, F_TYPE(old), &made));
}

FORTRAN(type_create_darray, (f_int * ranks, f_int *rank, f_int *dims, f_int *sizes, f_int *kinds,
                             f_int *blocks, f_int *grid, f_int *order, f_int *old, f_int *type, f_int *ierr))
{
    NEW_TYPE(
        MPI_Type_create_darray(*ranks, *rank, *dims, sizes, kinds, blocks, grid, *order, F_TYPE(old), &made));
}

FORTRAN(type_create_resized, (f_int * old, MPI_Aint *lb, MPI_Aint *extent, f_int *type, f_int *ierr))
{
    NEW_TYPE(MPI_Type_create_resized(F_TYPE(old), *lb, *extent, &made));
}

FORTRAN(type_dup, (f_int * old, f_int *type, f_int *ierr))
{
    NEW_TYPE(MPI_Type_dup(F_TYPE(old), &made));
}

FORTRAN(type_commit, (f_int * type, f_int *ierr))
{
    WITH(MPI_Datatype, type, MPI_Type_commit(&handle));
}

FORTRAN(type_free, (f_int * type, f_int *ierr))
{
    WITH(MPI_Datatype, type, MPI_Type_free(&handle));
}

FORTRAN(type_size, (f_int * type, f_int *size, f_int *ierr))
{
    *ierr = MPI_Type_size(F_TYPE(type), size);
}

#define SHORT_EXTENT(name, c_name)                                                                           \
    FORTRAN(name, (f_int * type, f_int * bytes, f_int * ierr))                                               \
    {                                                                                                        \
        MPI_Aint whole = 0;                                                                                  \
        *ierr = MPI_##c_name(F_TYPE(type), &whole);                                                          \
        *bytes = (f_int)whole;                                                                               \
    }
SHORT_EXTENT(type_extent, Type_extent)
SHORT_EXTENT(type_lb, Type_lb)
SHORT_EXTENT(type_ub, Type_ub)

FORTRAN(type_get_extent, (f_int * type, MPI_Aint *lb, MPI_Aint *extent, f_int *ierr))
{
    *ierr = MPI_Type_get_extent(F_TYPE(type), lb, extent);
}

FORTRAN(type_get_true_extent, (f_int * type, MPI_Aint *lb, MPI_Aint *extent, f_int *ierr))
{
    *ierr = MPI_Type_get_true_extent(F_TYPE(type), lb, extent);
}

FORTRAN(address, (void *at, f_int *address, f_int *ierr))
{
    *address = (f_int)((char *)at - (char *)&mpi_fortran_bottom_);
    *ierr = MPI_SUCCESS;
}

FORTRAN(get_address, (void *at, MPI_Aint *address, f_int *ierr))
{
    *address = (char *)at - (char *)&mpi_fortran_bottom_;
    *ierr = MPI_SUCCESS;
}

MPI_Aint mpi_aint_add_(MPI_Aint *base, MPI_Aint *displacement), mpi_aint_diff_(MPI_Aint *a, MPI_Aint *b);
MPI_Aint mpi_aint_add_(MPI_Aint *base, MPI_Aint *displacement)
{
    return *base + *displacement;
}

MPI_Aint mpi_aint_diff_(MPI_Aint *a, MPI_Aint *b)
{
    return *a - *b;
}

NAMES(type, Type, F_TYPE)

FORTRAN(pack, (void *buf, f_int *count, f_int *type, void *into, f_int *room, f_int *position, f_int *comm,
               f_int *ierr))
{
    *ierr = MPI_Pack(buf, *count, F_TYPE(type), into, *room, position, F_COMM(comm));
}

FORTRAN(unpack, (void *from, f_int *size, f_int *position, void *buf, f_int *count, f_int *type, f_int *comm,
                 f_int *ierr))
{
    *ierr = MPI_Unpack(from, *size, position, buf, *count, F_TYPE(type), F_COMM(comm));
}

FORTRAN(pack_size, (f_int * count, f_int *type, f_int *comm, f_int *size, f_int *ierr))
{
    *ierr = MPI_Pack_size(*count, F_TYPE(type), F_COMM(comm), size);
}

/* --- groups --- */

#define GROUP_OF(x) F_HANDLE(MPI_Group, *(x))
#define NEW_GROUP(call)                                                                                      \
    do {                                                                                                     \
        MPI_Group made;                                                                                      \
        *ierr = (call);                                                                                      \
        if (!*ierr)                                                                                          \
            *group = F_OF(made);                                                                             \
    } while (0)

FORTRAN(group_size, (f_int * group, f_int *size, f_int *ierr))
{
    *ierr = MPI_Group_size(GROUP_OF(group), size);
}

FORTRAN(group_rank, (f_int * group, f_int *rank, f_int *ierr))
{
    *ierr = MPI_Group_rank(GROUP_OF(group), rank);
}

FORTRAN(group_translate_ranks,
        (f_int * from, f_int *count, f_int *ranks, f_int *to, f_int *translated, f_int *ierr))
{
    *ierr = MPI_Group_translate_ranks(GROUP_OF(from), *count, ranks, GROUP_OF(to), translated);
}

FORTRAN(group_compare, (f_int * a, f_int *b, f_int *result, f_int *ierr))
{
    *ierr = MPI_Group_compare(GROUP_OF(a), GROUP_OF(b), result);
}

#define OF_TWO(name, c_name)                                                                                 \
    FORTRAN(name, (f_int * a, f_int * b, f_int * group, f_int * ierr))                                       \
    {                                                                                                        \
        NEW_GROUP(MPI_##c_name(GROUP_OF(a), GROUP_OF(b), &made));                                            \
    }
OF_TWO(group_union, Group_union)
OF_TWO(group_intersection, Group_intersection)
OF_TWO(group_difference, Group_difference)

FORTRAN(group_incl, (f_int * from, f_int *count, f_int *ranks, f_int *group, f_int *ierr))
{
    NEW_GROUP(MPI_Group_incl(GROUP_OF(from), *count, ranks, &made));
}

FORTRAN(group_excl, (f_int * from, f_int *count, f_int *ranks, f_int *group, f_int *ierr))
{
    NEW_GROUP(MPI_Group_excl(GROUP_OF(from), *count, ranks, &made));
}

FORTRAN(group_range_incl, (f_int * from, f_int *count, f_int ranges[][3], f_int *group, f_int *ierr))
{
    NEW_GROUP(MPI_Group_range_incl(GROUP_OF(from), *count, ranges, &made));
}

FORTRAN(group_range_excl, (f_int * from, f_int *count, f_int ranges[][3], f_int *group, f_int *ierr))
{
    NEW_GROUP(MPI_Group_range_excl(GROUP_OF(from), *count, ranges, &made));
}

FORTRAN(group_free, (f_int * group, f_int *ierr))
{
    WITH(MPI_Group, group, MPI_Group_free(&handle));
}

/* --- communicators --- */

#define NEW_COMM(call)                                                                                       \
    do {                                                                                                     \
        MPI_Comm made;                                                                                       \
        *ierr = (call);                                                                                      \
        if (!*ierr)                                                                                          \
            *to = F_OF(made);                                                                                \
    } while (0)

#define ASK_COMM(name, c_name)                                                                               \
    FORTRAN(name, (f_int * comm, f_int * value, f_int * ierr))                                               \
    {                                                                                                        \
        *ierr = MPI_##c_name(F_COMM(comm), value);                                                           \
    }
ASK_COMM(comm_size, Comm_size)
ASK_COMM(comm_rank, Comm_rank)
ASK_COMM(comm_test_inter, Comm_test_inter)
ASK_COMM(comm_remote_size, Comm_remote_size)
ASK_COMM(topo_test, Topo_test)
ASK_COMM(cartdim_get, Cartdim_get)

FORTRAN(comm_compare, (f_int * a, f_int *b, f_int *result, f_int *ierr))
{
    *ierr = MPI_Comm_compare(F_COMM(a), F_COMM(b), result);
}

FORTRAN(comm_group, (f_int * comm, f_int *group, f_int *ierr))
{
    NEW_GROUP(MPI_Comm_group(F_COMM(comm), &made));
}

FORTRAN(comm_remote_group, (f_int * comm, f_int *group, f_int *ierr))
{
    NEW_GROUP(MPI_Comm_remote_group(F_COMM(comm), &made));
}

FORTRAN(comm_dup, (f_int * comm, f_int *to, f_int *ierr))
{
    NEW_COMM(MPI_Comm_dup(F_COMM(comm), &made));
}

FORTRAN(comm_create, (f_int * comm, f_int *group, f_int *to, f_int *ierr))
{
    NEW_COMM(MPI_Comm_create(F_COMM(comm), GROUP_OF(group), &made));
}

FORTRAN(comm_split, (f_int * comm, f_int *color, f_int *key, f_int *to, f_int *ierr))
{
    NEW_COMM(MPI_Comm_split(F_COMM(comm), *color, *key, &made));
}

FORTRAN(comm_split_type, (f_int * comm, f_int *kind, f_int *key, f_int *info, f_int *to, f_int *ierr))
{
    NEW_COMM(MPI_Comm_split_type(F_COMM(comm), *kind, *key, F_HANDLE(MPI_Info, *info), &made));
}

FORTRAN(comm_free, (f_int * comm, f_int *ierr))
{
    WITH(MPI_Comm, comm, MPI_Comm_free(&handle));
}

FORTRAN(intercomm_create,
        (f_int * local, f_int *leader, f_int *bridge, f_int *remote, f_int *tag, f_int *to, f_int *ierr))
{
    NEW_COMM(MPI_Intercomm_create(F_COMM(local), *leader, F_COMM(bridge), *remote, *tag, &made));
}

FORTRAN(intercomm_merge, (f_int * comm, f_int *high, f_int *to, f_int *ierr))
{
    NEW_COMM(MPI_Intercomm_merge(F_COMM(comm), *high, &made));
}

NAMES(comm, Comm, F_COMM)

/* --- topologies --- */

FORTRAN(dims_create, (f_int * nodes, f_int *dims, f_int *sides, f_int *ierr))
{
    *ierr = MPI_Dims_create(*nodes, *dims, sides);
}

FORTRAN(cart_create,
        (f_int * comm, f_int *dims, f_int *sides, f_int *periods, f_int *reorder, f_int *to, f_int *ierr))
{
    NEW_COMM(MPI_Cart_create(F_COMM(comm), *dims, sides, periods, *reorder, &made));
}

FORTRAN(cart_coords, (f_int * comm, f_int *rank, f_int *most, f_int *coords, f_int *ierr))
{
    *ierr = MPI_Cart_coords(F_COMM(comm), *rank, *most, coords);
}

FORTRAN(cart_rank, (f_int * comm, f_int *coords, f_int *rank, f_int *ierr))
{
    *ierr = MPI_Cart_rank(F_COMM(comm), coords, rank);
}

FORTRAN(cart_shift, (f_int * comm, f_int *direction, f_int *by, f_int *source, f_int *dest, f_int *ierr))
{
    *ierr = MPI_Cart_shift(F_COMM(comm), *direction, *by, source, dest);
}

FORTRAN(cart_sub, (f_int * comm, f_int *keep, f_int *to, f_int *ierr))
{
    NEW_COMM(MPI_Cart_sub(F_COMM(comm), keep, &made));
}

FORTRAN(cart_get, (f_int * comm, f_int *most, f_int *sides, f_int *periods, f_int *coords, f_int *ierr))
{
    *ierr = MPI_Cart_get(F_COMM(comm), *most, sides, periods, coords);
}

FORTRAN(cart_map, (f_int * comm, f_int *dims, f_int *sides, f_int *periods, f_int *rank, f_int *ierr))
{
    *ierr = MPI_Cart_map(F_COMM(comm), *dims, sides, periods, rank);
}

FORTRAN(graph_create,
        (f_int * comm, f_int *nodes, f_int *ends, f_int *edges, f_int *reorder, f_int *to, f_int *ierr))
{
    NEW_COMM(MPI_Graph_create(F_COMM(comm), *nodes, ends, edges, *reorder, &made));
}

FORTRAN(graph_get,
        (f_int * comm, f_int *most_nodes, f_int *most_edges, f_int *ends, f_int *edges, f_int *ierr))
{
    *ierr = MPI_Graph_get(F_COMM(comm), *most_nodes, *most_edges, ends, edges);
}

FORTRAN(graphdims_get, (f_int * comm, f_int *nodes, f_int *edges, f_int *ierr))
{
    *ierr = MPI_Graphdims_get(F_COMM(comm), nodes, edges);
}

FORTRAN(graph_neighbors_count, (f_int * comm, f_int *rank, f_int *count, f_int *ierr))
{
    *ierr = MPI_Graph_neighbors_count(F_COMM(comm), *rank, count);
}

FORTRAN(graph_neighbors, (f_int * comm, f_int *rank, f_int *most, f_int *neighbors, f_int *ierr))
{
    *ierr = MPI_Graph_neighbors(F_COMM(comm), *rank, *most, neighbors);
}

FORTRAN(graph_map, (f_int * comm, f_int *nodes, f_int *ends, f_int *edges, f_int *rank, f_int *ierr))
{
    *ierr = MPI_Graph_map(F_COMM(comm), *nodes, ends, edges, rank);
}

/* --- attributes: INTEGERs; the functions of a key are Fortran's --- */

typedef void f_copy(f_int *comm, f_int *key, f_int *extra, f_int *in, f_int *out, f_int *flag, f_int *ierr);
typedef void f_delete(f_int *comm, f_int *key, f_int *value, f_int *extra, f_int *ierr);

struct f_key {
    f_copy *copy;
    f_delete *drop;
    f_int *extra;
};

FORTRAN(null_copy_fn,
        (f_int * comm, f_int *key, f_int *extra, f_int *in, f_int *out, f_int *flag, f_int *ierr))
{
    (void)comm, (void)key, (void)extra, (void)in, (void)out;
    *flag = 0, *ierr = MPI_SUCCESS;
}

FORTRAN(dup_fn, (f_int * comm, f_int *key, f_int *extra, f_int *in, f_int *out, f_int *flag, f_int *ierr))
{
    (void)comm, (void)key, (void)extra;
    *out = *in, *flag = 1, *ierr = MPI_SUCCESS;
}

FORTRAN(null_delete_fn, (f_int * comm, f_int *key, f_int *value, f_int *extra, f_int *ierr))
{
    (void)comm, (void)key, (void)value, (void)extra;
    *ierr = MPI_SUCCESS;
}

static int call_copy(MPI_Comm comm, int key, void *extra, void *in, void *out, int *flag)
{
    const struct f_key *k = extra;
    f_int c = F_OF(comm), value = (f_int)(intptr_t)in, copied = 0, code = MPI_SUCCESS;
    k->copy(&c, &key, k->extra, &value, &copied, flag, &code);
    *(void **)out = (void *)(intptr_t)copied;
    return code;
}

static int call_delete(MPI_Comm comm, int key, void *value, void *extra)
{
    const struct f_key *k = extra;
    f_int c = F_OF(comm), v = (f_int)(intptr_t)value, code = MPI_SUCCESS;
    k->drop(&c, &key, &v, k->extra, &code);
    return code;
}

FORTRAN(keyval_create, (f_copy * copy, f_delete *drop, f_int *key, f_int *extra, f_int *ierr))
{
    struct f_key *k = get_memory(sizeof *k); /* as long as the key */
    *k = (struct f_key){copy, drop, extra};
    *ierr = MPI_Comm_create_keyval(call_copy, call_delete, key, k);
}

FORTRAN(keyval_free, (f_int * key, f_int *ierr))
{
    *ierr = MPI_Comm_free_keyval(key);
}

FORTRAN(attr_put, (f_int * comm, f_int *key, f_int *value, f_int *ierr))
{
    *ierr = MPI_Comm_set_attr(F_COMM(comm), *key, (void *)(intptr_t)*value);
}

FORTRAN(attr_get, (f_int * comm, f_int *key, f_int *value, f_int *flag, f_int *ierr))
{
    void *found;
    *ierr = MPI_Comm_get_attr(F_COMM(comm), *key, &found, flag);
    if (!*ierr && *flag) /* those of MPI's own are pointers to numbers */
        *value = *key <= MPI_LASTUSEDCODE ? *(int *)found : (f_int)(intptr_t)found;
}

FORTRAN(attr_delete, (f_int * comm, f_int *key, f_int *ierr))
{
    *ierr = MPI_Comm_delete_attr(F_COMM(comm), *key);
}

FORTRAN(comm_get_attr, (f_int * comm, f_int *key, MPI_Aint *value, f_int *flag, f_int *ierr))
{
    void *found;
    *ierr = MPI_Comm_get_attr(F_COMM(comm), *key, &found, flag);
    if (!*ierr && *flag)
        *value = *key <= MPI_LASTUSEDCODE ? *(int *)found : (MPI_Aint)found;
}

FORTRAN(comm_set_attr, (f_int * comm, f_int *key, MPI_Aint *value, f_int *ierr))
{
    *ierr = MPI_Comm_set_attr(F_COMM(comm), *key, (void *)*value);
}

/* --- errors --- */

#define NEW_HANDLER(call)                                                                                    \
    do {                                                                                                     \
        MPI_Errhandler made;                                                                                 \
        *ierr = (call);                                                                                      \
        if (!*ierr)                                                                                          \
            *handler = F_OF(made);                                                                           \
    } while (0)

#define HANDLERS(create, set, get)                                                                           \
    FORTRAN(create, (MPI_Comm_errhandler_function * function, f_int * handler, f_int * ierr))                \
    {                                                                                                        \
        NEW_HANDLER(MPI_Comm_create_errhandler(function, &made));                                            \
    }                                                                                                        \
    FORTRAN(set, (f_int * comm, f_int * handler, f_int * ierr))                                              \
    {                                                                                                        \
        *ierr = MPI_Comm_set_errhandler(F_COMM(comm), F_HANDLE(MPI_Errhandler, *handler));                   \
    }                                                                                                        \
    FORTRAN(get, (f_int * comm, f_int * handler, f_int * ierr))                                              \
    {                                                                                                        \
        NEW_HANDLER(MPI_Comm_get_errhandler(F_COMM(comm), &made));                                           \
    }
HANDLERS(errhandler_create, errhandler_set, errhandler_get)
HANDLERS(comm_create_errhandler, comm_set_errhandler, comm_get_errhandler)

FORTRAN(comm_call_errhandler, (f_int * comm, f_int *code, f_int *ierr))
{
    *ierr = MPI_Comm_call_errhandler(F_COMM(comm), *code);
}

FORTRAN(errhandler_free, (f_int * handler, f_int *ierr))
{
    WITH(MPI_Errhandler, handler, MPI_Errhandler_free(&handle));
}

FORTRAN(error_string, (f_int * code, char *text, f_int *length, f_int *ierr, size_t room))
{
    char whole[MPI_MAX_ERROR_STRING];
    *ierr = MPI_Error_string(*code, whole, length);
    f_give_text(text, room, whole);
}

FORTRAN(error_class, (f_int * code, f_int *kind, f_int *ierr))
{
    *ierr = MPI_Error_class(*code, kind);
}

FORTRAN(add_error_class, (f_int * kind, f_int *ierr))
{
    *ierr = MPI_Add_error_class(kind);
}

FORTRAN(add_error_code, (f_int * kind, f_int *code, f_int *ierr))
{
    *ierr = MPI_Add_error_code(*kind, code);
}

FORTRAN(add_error_string, (f_int * code, const char *text, f_int *ierr, size_t length))
{
    char *whole = f_text(text, length);
    *ierr = MPI_Add_error_string(*code, whole);
    free(whole);
}
