/* attribute_names.c - Fortran's names for communicators' attributes of MPI-1: INTEGERs; the functions of a
 * key are Fortran's. */
#include "fortran.h"

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
    *flag = 0, IERR = MPI_SUCCESS;
}

FORTRAN(dup_fn, (f_int * comm, f_int *key, f_int *extra, f_int *in, f_int *out, f_int *flag, f_int *ierr))
{
    (void)comm, (void)key, (void)extra;
    *out = *in, *flag = 1, IERR = MPI_SUCCESS;
}

FORTRAN(null_delete_fn, (f_int * comm, f_int *key, f_int *value, f_int *extra, f_int *ierr))
{
    (void)comm, (void)key, (void)value, (void)extra;
    IERR = MPI_SUCCESS;
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
    IERR = attribute_key((void *)call_copy, (void *)call_delete, key, k, true);
}

FORTRAN(keyval_free, (f_int * key, f_int *ierr))
{
    IERR = MPI_Comm_free_keyval(key);
}

FORTRAN(comm_set_attr, (f_int * comm, f_int *key, MPI_Aint *value, f_int *ierr))
{
    IERR = MPI_Comm_set_attr(F_COMM(comm), *key, (void *)*value);
    if (!IERR)
        attribute_last_is_number(comm_of(F_COMM(comm))->attributes);
}

FORTRAN(comm_get_attr, (f_int * comm, f_int *key, MPI_Aint *value, f_int *flag, f_int *ierr))
{
    void *found;
    IERR = MPI_Comm_get_attr(F_COMM(comm), *key, &found, flag);
    if (!IERR && *flag) /* those of MPI's own are pointers to numbers */
        *value = *key <= MPI_LASTUSEDCODE ? *(int *)found
                                          : attribute_number(comm_of(F_COMM(comm))->attributes, found);
}

FORTRAN(attr_put, (f_int * comm, f_int *key, f_int *value, f_int *ierr))
{
    pmpi_comm_set_attr_(comm, key, &(MPI_Aint){*value}, ierr);
}

FORTRAN(attr_get, (f_int * comm, f_int *key, f_int *value, f_int *flag, f_int *ierr))
{
    MPI_Aint number;
    pmpi_comm_get_attr_(comm, key, &number, flag, ierr);
    if (!IERR && *flag)
        *value = (f_int)number;
}

FORTRAN(attr_delete, (f_int * comm, f_int *key, f_int *ierr))
{
    IERR = MPI_Comm_delete_attr(F_COMM(comm), *key);
}
