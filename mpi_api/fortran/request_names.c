/* request_names.c - Fortran's names for generalized requests, and for what programs write into statuses. */
#include "fortran.h"

FORTRAN(request_get_status, (f_int * request, f_int *flag, f_int *status, f_int *ierr))
{
    IERR = MPI_Request_get_status(F_HANDLE(MPI_Request, *request), flag, f_status(status));
}

FORTRAN(status_set_elements, (f_int * status, f_int *type, f_int *count, f_int *ierr))
{
    IERR = MPI_Status_set_elements((MPI_Status *)status, F_TYPE(type), *count);
}

FORTRAN(status_set_elements_x, (f_int * status, f_int *type, MPI_Count *count, f_int *ierr))
{
    IERR = MPI_Status_set_elements_x((MPI_Status *)status, F_TYPE(type), *count);
}

FORTRAN(status_set_cancelled, (f_int * status, f_int *flag, f_int *ierr))
{
    IERR = MPI_Status_set_cancelled((MPI_Status *)status, *flag);
}

/* A generalized request's functions, which are Fortran's, and what they are given. */
struct f_general {
    void (*query)(MPI_Aint *extra, f_int *status, f_int *ierr);
    void (*release)(MPI_Aint *extra, f_int *ierr);
    void (*cancel)(MPI_Aint *extra, f_int *complete, f_int *ierr);
    MPI_Aint *extra; /* the program's variable: its functions may change it, as with other MPI libraries */
};

static int query(void *extra, MPI_Status *status)
{
    struct f_general *g = extra;
    f_int code = MPI_SUCCESS;
    g->query(g->extra, (f_int *)status, &code);
    return code;
}

static int release(void *extra)
{
    struct f_general *g = extra;
    f_int code = MPI_SUCCESS;
    g->release(g->extra, &code);
    free(g);
    return code;
}

static int cancel(void *extra, int complete)
{
    struct f_general *g = extra;
    f_int code = MPI_SUCCESS;
    g->cancel(g->extra, &complete, &code);
    return code;
}

FORTRAN(grequest_start,
        (void (*query_it)(MPI_Aint *, f_int *, f_int *), void (*release_it)(MPI_Aint *, f_int *),
         void (*cancel_it)(MPI_Aint *, f_int *, f_int *), MPI_Aint *extra, f_int *request, f_int *ierr))
{
    struct f_general *g = get_memory(sizeof *g);
    *g = (struct f_general){query_it, release_it, cancel_it, extra};
    NEW(MPI_Request, request, MPI_Grequest_start(query, release, cancel, g, &made));
}

FORTRAN(grequest_complete, (f_int * request, f_int *ierr))
{
    IERR = MPI_Grequest_complete(F_HANDLE(MPI_Request, *request));
}
