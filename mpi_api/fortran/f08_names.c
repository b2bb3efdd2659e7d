/* f08_names.c - what mpi_f08 has besides the calls of mpif.h: handles are compared, statuses copied, the
 * address of a buffer is answered. */
#include "fortran.h"

f_int mpi_f08_equal(const f_int *a, const f_int *b), mpi_f08_differ(const f_int *a, const f_int *b);
f_int mpi_f08_equal(const f_int *a, const f_int *b)
{
    return *a == *b;
}

f_int mpi_f08_differ(const f_int *a, const f_int *b)
{
    return *a != *b;
}

FORTRAN(status_f2f08, (const f_int *from, MPI_Status *to, f_int *ierr))
{
    memcpy(to, from, sizeof *to);
    IERR = MPI_SUCCESS;
}

FORTRAN(status_f082f, (const MPI_Status *from, f_int *to, f_int *ierr))
{
    memcpy(to, from, sizeof *from);
    IERR = MPI_SUCCESS;
}

void pmpi_f08_buffer_detach(void **buf, f_int *size, f_int *ierr);
void mpi_f08_buffer_detach(void **buf, f_int *size, f_int *ierr)
    __attribute__((weak, alias("pmpi_f08_buffer_detach")));

void pmpi_f08_buffer_detach(void **buf, f_int *size, f_int *ierr)
{
    IERR = MPI_Buffer_detach(buf, size);
}

/* The compiler takes it that the buffer may have changed. */
FORTRAN(f_sync_reg, (void *buf))
{
    (void)buf;
}
