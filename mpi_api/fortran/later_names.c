/* later_names.c - Fortran's names for calls of later standards: probes that take the message, what a
 * datatype was made of, threads. */
#include "fortran.h"

FORTRAN(mprobe, (f_int * from, f_int *tag, f_int *comm, f_int *message, f_int *status, f_int *ierr))
{
    WITH(MPI_Message, message, MPI_Mprobe(*from, *tag, F_COMM(comm), &handle, f_status(status)));
}

FORTRAN(improbe,
        (f_int * from, f_int *tag, f_int *comm, f_int *found, f_int *message, f_int *status, f_int *ierr))
{
    WITH(MPI_Message, message, MPI_Improbe(*from, *tag, F_COMM(comm), found, &handle, f_status(status)));
}

FORTRAN(mrecv, (void *buf, f_int *count, f_int *type, f_int *message, f_int *status, f_int *ierr))
{
    WITH(MPI_Message, message, MPI_Mrecv(f_buffer(buf), *count, F_TYPE(type), &handle, f_status(status)));
}

FORTRAN(imrecv, (void *buf, f_int *count, f_int *type, f_int *message, f_int *request, f_int *ierr))
{
    MPI_Request made;
    WITH(MPI_Message, message, MPI_Imrecv(f_buffer(buf), *count, F_TYPE(type), &handle, &made));
    if (!IERR)
        *request = F_OF(made);
}

FORTRAN(type_get_envelope,
        (f_int * type, f_int *ints, f_int *addresses, f_int *types, f_int *combiner, f_int *ierr))
{
    IERR = MPI_Type_get_envelope(F_TYPE(type), ints, addresses, types, combiner);
}

FORTRAN(query_thread, (f_int * provided, f_int *ierr))
{
    IERR = MPI_Query_thread(provided);
}

FORTRAN(is_thread_main, (f_int * is, f_int *ierr))
{
    IERR = MPI_Is_thread_main(is);
}
