/* run_names.c - Fortran's names for the calls of the run itself. */
#include "fortran.h"

FORTRAN(init, (f_int * ierr))
{
    IERR = MPI_Init(NULL, NULL);
}

FORTRAN(init_thread, (f_int * required, f_int *provided, f_int *ierr))
{
    IERR = MPI_Init_thread(NULL, NULL, *required, provided);
}

FORTRAN(finalize, (f_int * ierr))
{
    IERR = MPI_Finalize();
}

FORTRAN(initialized, (f_int * flag, f_int *ierr))
{
    IERR = MPI_Initialized(flag);
}

FORTRAN(finalized, (f_int * flag, f_int *ierr))
{
    IERR = MPI_Finalized(flag);
}

FORTRAN(abort, (f_int * comm, f_int *code, f_int *ierr))
{
    IERR = MPI_Abort(F_COMM(comm), *code);
}

FORTRAN(get_processor_name, (char *name, f_int *length, f_int *ierr, size_t room))
{
    char text[MPI_MAX_PROCESSOR_NAME];
    IERR = MPI_Get_processor_name(text, length);
    f_give_text(name, room, text);
}

FORTRAN(get_version, (f_int * version, f_int *subversion, f_int *ierr))
{
    IERR = MPI_Get_version(version, subversion);
}

FORTRAN(get_library_version, (char *version, f_int *length, f_int *ierr, size_t room))
{
    char text[MPI_MAX_LIBRARY_VERSION_STRING];
    IERR = MPI_Get_library_version(text, length);
    f_give_text(version, room, text);
}

/* The memory's address, as an INTEGER of MPI_ADDRESS_KIND or a C_PTR. */
FORTRAN(alloc_mem, (MPI_Aint * bytes, f_int *info, void **memory, f_int *ierr))
{
    IERR = MPI_Alloc_mem(*bytes, F_HANDLE(MPI_Info, *info), memory);
}

FORTRAN(free_mem, (void *memory, f_int *ierr))
{
    IERR = MPI_Free_mem(memory);
}

FORTRAN(pcontrol, (f_int * level))
{
    (void)level;
}

double pmpi_wtime_(void), pmpi_wtick_(void);
double mpi_wtime_(void) __attribute__((weak, alias("pmpi_wtime_")));
double mpi_wtick_(void) __attribute__((weak, alias("pmpi_wtick_")));

double pmpi_wtime_(void)
{
    return MPI_Wtime();
}

double pmpi_wtick_(void)
{
    return MPI_Wtick();
}
