/* type_names.c - Fortran's names for datatypes, and for packing. */
#include "fortran.h"

static MPI_Aint *addresses_of(const f_int *list, f_int count)
{
    MPI_Aint *a = get_memory(((size_t)count + 1) * sizeof *a);
    for (f_int i = 0; i < count; i++)
        a[i] = list[i];
    return a;
}

FORTRAN(type_contiguous, (f_int * count, f_int *old, f_int *type, f_int *ierr))
{
    NEW(MPI_Datatype, type, MPI_Type_contiguous(*count, F_TYPE(old), &made));
}

FORTRAN(type_vector, (f_int * count, f_int *length, f_int *stride, f_int *old, f_int *type, f_int *ierr))
{
    NEW(MPI_Datatype, type, MPI_Type_vector(*count, *length, *stride, F_TYPE(old), &made));
}

FORTRAN(type_hvector, (f_int * count, f_int *length, f_int *stride, f_int *old, f_int *type, f_int *ierr))
{
    NEW(MPI_Datatype, type, MPI_Type_create_hvector(*count, *length, *stride, F_TYPE(old), &made));
}

FORTRAN(type_create_hvector,
        (f_int * count, f_int *length, MPI_Aint *stride, f_int *old, f_int *type, f_int *ierr))
{
    NEW(MPI_Datatype, type, MPI_Type_create_hvector(*count, *length, *stride, F_TYPE(old), &made));
}

FORTRAN(type_indexed, (f_int * count, f_int *lengths, f_int *at, f_int *old, f_int *type, f_int *ierr))
{
    NEW(MPI_Datatype, type, MPI_Type_indexed(*count, lengths, at, F_TYPE(old), &made));
}

FORTRAN(type_hindexed, (f_int * count, f_int *lengths, f_int *at, f_int *old, f_int *type, f_int *ierr))
{
    MPI_Aint *bytes = addresses_of(at, *count);
    NEW(MPI_Datatype, type, MPI_Type_create_hindexed(*count, lengths, bytes, F_TYPE(old), &made));
    free(bytes);
}

FORTRAN(type_create_hindexed,
        (f_int * count, f_int *lengths, MPI_Aint *at, f_int *old, f_int *type, f_int *ierr))
{
    NEW(MPI_Datatype, type, MPI_Type_create_hindexed(*count, lengths, at, F_TYPE(old), &made));
}

FORTRAN(type_create_indexed_block,
        (f_int * count, f_int *length, f_int *at, f_int *old, f_int *type, f_int *ierr))
{
    NEW(MPI_Datatype, type, MPI_Type_create_indexed_block(*count, *length, at, F_TYPE(old), &made));
}

FORTRAN(type_create_hindexed_block,
        (f_int * count, f_int *length, MPI_Aint *at, f_int *old, f_int *type, f_int *ierr))
{
    NEW(MPI_Datatype, type, MPI_Type_create_hindexed_block(*count, *length, at, F_TYPE(old), &made));
}

FORTRAN(type_struct, (f_int * count, f_int *lengths, f_int *at, f_int *types, f_int *type, f_int *ierr))
{
    MPI_Aint *bytes = addresses_of(at, *count);
    MPI_Datatype *list = f_types(types, *count);
    NEW(MPI_Datatype, type, MPI_Type_create_struct(*count, lengths, bytes, list, &made));
    free(bytes);
    free(list);
}

FORTRAN(type_create_struct,
        (f_int * count, f_int *lengths, MPI_Aint *at, f_int *types, f_int *type, f_int *ierr))
{
    MPI_Datatype *list = f_types(types, *count);
    NEW(MPI_Datatype, type, MPI_Type_create_struct(*count, lengths, at, list, &made));
    free(list);
}

FORTRAN(type_create_subarray, (f_int * dims, f_int *sizes, f_int *subsizes, f_int *starts, f_int *order,
                               f_int *old, f_int *type, f_int *ierr))
{
    NEW(MPI_Datatype, type,
        MPI_Type_create_subarray(*dims, sizes, subsizes, starts, *order, F_TYPE(old), &made));
}

FORTRAN(type_create_darray, (f_int * ranks, f_int *rank, f_int *dims, f_int *sizes, f_int *kinds,
                             f_int *blocks, f_int *grid, f_int *order, f_int *old, f_int *type, f_int *ierr))
{
    NEW(MPI_Datatype, type,
        MPI_Type_create_darray(*ranks, *rank, *dims, sizes, kinds, blocks, grid, *order, F_TYPE(old), &made));
}

FORTRAN(type_create_resized, (f_int * old, MPI_Aint *lb, MPI_Aint *extent, f_int *type, f_int *ierr))
{
    NEW(MPI_Datatype, type, MPI_Type_create_resized(F_TYPE(old), *lb, *extent, &made));
}

FORTRAN(type_dup, (f_int * old, f_int *type, f_int *ierr))
{
    NEW(MPI_Datatype, type, MPI_Type_dup(F_TYPE(old), &made));
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
    IERR = MPI_Type_size(F_TYPE(type), size);
}

FORTRAN(type_size_x, (f_int * type, MPI_Count *size, f_int *ierr))
{
    IERR = MPI_Type_size_x(F_TYPE(type), size);
}

#define SHORT_EXTENT(name, c_name)                                                                           \
    FORTRAN(name, (f_int * type, f_int * bytes, f_int * ierr))                                               \
    {                                                                                                        \
        MPI_Aint whole = 0;                                                                                  \
        IERR = MPI_##c_name(F_TYPE(type), &whole);                                                           \
        *bytes = (f_int)whole;                                                                               \
    }
SHORT_EXTENT(type_extent, Type_extent)
SHORT_EXTENT(type_lb, Type_lb)
SHORT_EXTENT(type_ub, Type_ub)

#define EXTENT(name, c_name, type_of_value)                                                                  \
    FORTRAN(name, (f_int * type, type_of_value * lb, type_of_value * extent, f_int * ierr))                  \
    {                                                                                                        \
        IERR = MPI_##c_name(F_TYPE(type), lb, extent);                                                       \
    }
EXTENT(type_get_extent, Type_get_extent, MPI_Aint)
EXTENT(type_get_extent_x, Type_get_extent_x, MPI_Count)
EXTENT(type_get_true_extent, Type_get_true_extent, MPI_Aint)
EXTENT(type_get_true_extent_x, Type_get_true_extent_x, MPI_Count)

FORTRAN(address, (void *at, f_int *address, f_int *ierr))
{
    *address = (f_int)((char *)at - (char *)&mpi_fortran_bottom_);
    IERR = MPI_SUCCESS;
}

FORTRAN(get_address, (void *at, MPI_Aint *address, f_int *ierr))
{
    *address = (char *)at - (char *)&mpi_fortran_bottom_;
    IERR = MPI_SUCCESS;
}

MPI_Aint pmpi_aint_add_(MPI_Aint *base, MPI_Aint *displacement), pmpi_aint_diff_(MPI_Aint *a, MPI_Aint *b);
MPI_Aint mpi_aint_add_(MPI_Aint *, MPI_Aint *) __attribute__((weak, alias("pmpi_aint_add_")));
MPI_Aint mpi_aint_diff_(MPI_Aint *, MPI_Aint *) __attribute__((weak, alias("pmpi_aint_diff_")));

MPI_Aint pmpi_aint_add_(MPI_Aint *base, MPI_Aint *displacement)
{
    return *base + *displacement;
}

MPI_Aint pmpi_aint_diff_(MPI_Aint *a, MPI_Aint *b)
{
    return *a - *b;
}

NAMES(type, Type, F_TYPE)

FORTRAN(pack, (void *buf, f_int *count, f_int *type, void *into, f_int *room, f_int *position, f_int *comm,
               f_int *ierr))
{
    IERR = MPI_Pack(buf, *count, F_TYPE(type), into, *room, position, F_COMM(comm));
}

FORTRAN(unpack, (void *from, f_int *size, f_int *position, void *buf, f_int *count, f_int *type, f_int *comm,
                 f_int *ierr))
{
    IERR = MPI_Unpack(from, *size, position, buf, *count, F_TYPE(type), F_COMM(comm));
}

FORTRAN(pack_size, (f_int * count, f_int *type, f_int *comm, f_int *size, f_int *ierr))
{
    IERR = MPI_Pack_size(*count, F_TYPE(type), F_COMM(comm), size);
}

FORTRAN(pack_external, (const char *name, void *buf, f_int *count, f_int *type, void *into, MPI_Aint *room,
                        MPI_Aint *position, f_int *ierr, size_t length))
{
    char *text = f_text(name, length);
    IERR = MPI_Pack_external(text, buf, *count, F_TYPE(type), into, *room, position);
    free(text);
}

FORTRAN(unpack_external, (const char *name, void *from, MPI_Aint *size, MPI_Aint *position, void *buf,
                          f_int *count, f_int *type, f_int *ierr, size_t length))
{
    char *text = f_text(name, length);
    IERR = MPI_Unpack_external(text, from, *size, position, buf, *count, F_TYPE(type));
    free(text);
}

FORTRAN(pack_external_size,
        (const char *name, f_int *count, f_int *type, MPI_Aint *size, f_int *ierr, size_t length))
{
    char *text = f_text(name, length);
    IERR = MPI_Pack_external_size(text, *count, F_TYPE(type), size);
    free(text);
}

/* A variable as gfortran describes it where its type and rank may be any. */
struct described {
    void *base;
    size_t offset, element_bytes;
};

FORTRAN(sizeof, (const struct described *x, f_int *size, f_int *ierr))
{
    *size = (f_int)x->element_bytes;
    IERR = MPI_SUCCESS;
}

FORTRAN(type_match_size, (f_int * class, f_int *bytes, f_int *type, f_int *ierr))
{
    NEW(MPI_Datatype, type, MPI_Type_match_size(*class, *bytes, &made));
}

FORTRAN(type_create_f90_real, (f_int * digits, f_int *range, f_int *type, f_int *ierr))
{
    NEW(MPI_Datatype, type, MPI_Type_create_f90_real(*digits, *range, &made));
}

FORTRAN(type_create_f90_complex, (f_int * digits, f_int *range, f_int *type, f_int *ierr))
{
    NEW(MPI_Datatype, type, MPI_Type_create_f90_complex(*digits, *range, &made));
}

FORTRAN(type_create_f90_integer, (f_int * range, f_int *type, f_int *ierr))
{
    NEW(MPI_Datatype, type, MPI_Type_create_f90_integer(*range, &made));
}

FORTRAN(type_get_contents, (f_int * type, f_int *most_ints, f_int *most_addresses, f_int *most_types,
                            f_int *ints, MPI_Aint *addresses, f_int *types, f_int *ierr))
{
    int n_ints, n_addresses, n_types = 0, combiner;
    MPI_Datatype *list = get_memory((size_t)*most_types * sizeof *list);
    IERR =
        MPI_Type_get_contents(F_TYPE(type), *most_ints, *most_addresses, *most_types, ints, addresses, list);
    if (!IERR)
        MPI_Type_get_envelope(F_TYPE(type), &n_ints, &n_addresses, &n_types, &combiner);
    for (int i = 0; i < n_types; i++)
        types[i] = F_OF(list[i]);
    free(list);
}
