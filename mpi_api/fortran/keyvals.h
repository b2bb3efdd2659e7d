/* keyvals.h - Fortran's names for MPI-2's attribute keys, of any object: values are INTEGERs of
 * MPI_ADDRESS_KIND, the functions of a key are Fortran's. */
#ifndef MPI_KEYVALS_H
#define MPI_KEYVALS_H
#include "fortran.h"

typedef void f_copy(f_int *handle, f_int *key, MPI_Aint *extra, MPI_Aint *in, MPI_Aint *out, f_int *flag,
                    f_int *ierr);
typedef void f_delete(f_int *handle, f_int *key, MPI_Aint *value, MPI_Aint *extra, f_int *ierr);

struct f_key {
    f_copy *copy;
    f_delete *drop;
    MPI_Aint extra;
};

static int call_copy(void *handle, int key, void *extra, void *in, void *out, int *flag)
{
    struct f_key *k = extra;
    f_int h = F_OF(handle), code = MPI_SUCCESS;
    MPI_Aint value = (MPI_Aint)in, copied = 0;
    k->copy(&h, &key, &k->extra, &value, &copied, flag, &code);
    memcpy(out, &copied, sizeof copied);
    return code;
}

static int call_delete(void *handle, int key, void *value, void *extra)
{
    struct f_key *k = extra;
    f_int h = F_OF(handle), code = MPI_SUCCESS;
    MPI_Aint v = (MPI_Aint)value;
    k->drop(&h, &key, &v, &k->extra, &code);
    return code;
}

static int make_key(f_copy *copy, f_delete *drop, f_int *key, MPI_Aint extra)
{
    struct f_key *k = get_memory(sizeof *k); /* as long as the key */
    *k = (struct f_key){copy, drop, extra};
    return attribute_key((void *)call_copy, (void *)call_delete, key, k, true);
}

#define KEYS(lower, Upper, type)                                                                             \
    FORTRAN(lower##_null_copy_fn, (f_int * handle, f_int * key, MPI_Aint * extra, MPI_Aint * in,             \
                                   MPI_Aint * out, f_int * flag, f_int * ierr))                              \
    {                                                                                                        \
        (void)handle, (void)key, (void)extra, (void)in, (void)out;                                           \
        *flag = 0, IERR = MPI_SUCCESS;                                                                       \
    }                                                                                                        \
    FORTRAN(lower##_dup_fn, (f_int * handle, f_int * key, MPI_Aint * extra, MPI_Aint * in, MPI_Aint * out,   \
                             f_int * flag, f_int * ierr))                                                    \
    {                                                                                                        \
        (void)handle, (void)key, (void)extra;                                                                \
        *out = *in, *flag = 1, IERR = MPI_SUCCESS;                                                           \
    }                                                                                                        \
    FORTRAN(lower##_null_delete_fn,                                                                          \
            (f_int * handle, f_int * key, MPI_Aint * value, MPI_Aint * extra, f_int * ierr))                 \
    {                                                                                                        \
        (void)handle, (void)key, (void)value, (void)extra;                                                   \
        IERR = MPI_SUCCESS;                                                                                  \
    }                                                                                                        \
    FORTRAN(lower##_create_keyval,                                                                           \
            (f_copy * copy, f_delete * drop, f_int * key, MPI_Aint * extra, f_int * ierr))                   \
    {                                                                                                        \
        IERR = make_key(copy, drop, key, *extra);                                                            \
    }                                                                                                        \
    FORTRAN(lower##_free_keyval, (f_int * key, f_int * ierr))                                                \
    {                                                                                                        \
        IERR = attribute_key_free(CALL_##Upper##_free_keyval, key);                                          \
    }                                                                                                        \
    FORTRAN(lower##_delete_attr, (f_int * handle, f_int * key, f_int * ierr))                                \
    {                                                                                                        \
        IERR = MPI_##Upper##_delete_attr(F_HANDLE(type, *handle), *key);                                     \
    }
#endif
