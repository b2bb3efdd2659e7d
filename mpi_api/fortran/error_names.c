/* error_names.c - Fortran's names for error handlers, codes and classes. */
#include "fortran.h"

#define HANDLERS(create, set, get)                                                                           \
    FORTRAN(create, (MPI_Comm_errhandler_function * function, f_int * handler, f_int * ierr))                \
    {                                                                                                        \
        NEW(MPI_Errhandler, handler, MPI_Comm_create_errhandler(function, &made));                           \
    }                                                                                                        \
    FORTRAN(set, (f_int * comm, f_int * handler, f_int * ierr))                                              \
    {                                                                                                        \
        IERR = MPI_Comm_set_errhandler(F_COMM(comm), F_HANDLE(MPI_Errhandler, *handler));                    \
    }                                                                                                        \
    FORTRAN(get, (f_int * comm, f_int * handler, f_int * ierr))                                              \
    {                                                                                                        \
        NEW(MPI_Errhandler, handler, MPI_Comm_get_errhandler(F_COMM(comm), &made));                          \
    }
HANDLERS(errhandler_create, errhandler_set, errhandler_get)
HANDLERS(comm_create_errhandler, comm_set_errhandler, comm_get_errhandler)

FORTRAN(comm_call_errhandler, (f_int * comm, f_int *code, f_int *ierr))
{
    IERR = MPI_Comm_call_errhandler(F_COMM(comm), *code);
}

FORTRAN(errhandler_free, (f_int * handler, f_int *ierr))
{
    WITH(MPI_Errhandler, handler, MPI_Errhandler_free(&handle));
}

FORTRAN(error_string, (f_int * code, char *text, f_int *length, f_int *ierr, size_t room))
{
    char whole[MPI_MAX_ERROR_STRING];
    IERR = MPI_Error_string(*code, whole, length);
    f_give_text(text, room, whole);
}

FORTRAN(error_class, (f_int * code, f_int *kind, f_int *ierr))
{
    IERR = MPI_Error_class(*code, kind);
}

FORTRAN(add_error_class, (f_int * kind, f_int *ierr))
{
    IERR = MPI_Add_error_class(kind);
}

FORTRAN(add_error_code, (f_int * kind, f_int *code, f_int *ierr))
{
    IERR = MPI_Add_error_code(*kind, code);
}

FORTRAN(add_error_string, (f_int * code, const char *text, f_int *ierr, size_t length))
{
    char *whole = f_text(text, length);
    IERR = MPI_Add_error_string(*code, whole);
    free(whole);
}
