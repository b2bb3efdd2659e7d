/* keyval_names.c - Fortran's names for MPI-2's attributes of communicators and datatypes. */
#include "keyvals.h"

KEYS(comm, Comm, MPI_Comm)
KEYS(type, Type, MPI_Datatype)

FORTRAN(type_set_attr, (f_int * type, f_int *key, MPI_Aint *value, f_int *ierr))
{
    IERR = MPI_Type_set_attr(F_TYPE(type), *key, (void *)*value);
    if (!IERR)
        attribute_last_is_number(type_of(F_TYPE(type))->attributes);
}

FORTRAN(type_get_attr, (f_int * type, f_int *key, MPI_Aint *value, f_int *flag, f_int *ierr))
{
    void *found;
    IERR = MPI_Type_get_attr(F_TYPE(type), *key, &found, flag);
    if (!IERR && *flag)
        *value = attribute_number(type_of(F_TYPE(type))->attributes, found);
}
