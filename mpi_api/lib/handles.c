/* handles.c - handles as Fortran has them: the same numbers. */
#include <string.h>
#include "lib.h"

#define HANDLES(type, name)                                                                                  \
    MPI_Fint PMPI_##name##_c2f(type handle)                                                                  \
    {                                                                                                        \
        return (MPI_Fint)(intptr_t)handle;                                                                   \
    }                                                                                                        \
    type PMPI_##name##_f2c(MPI_Fint handle)                                                                  \
    {                                                                                                        \
        return (type)(intptr_t)handle;                                                                       \
    }                                                                                                        \
    MPI_Fint MPI_##name##_c2f(type handle) __attribute__((weak, alias("PMPI_" #name "_c2f")));               \
    type MPI_##name##_f2c(MPI_Fint handle) __attribute__((weak, alias("PMPI_" #name "_f2c")));
HANDLES(MPI_Comm, Comm)
HANDLES(MPI_Datatype, Type)
HANDLES(MPI_Group, Group)
HANDLES(MPI_Request, Request)
HANDLES(MPI_Op, Op)
HANDLES(MPI_Info, Info)
HANDLES(MPI_Errhandler, Errhandler)
HANDLES(MPI_Message, Message)
HANDLES(MPI_File, File)
HANDLES(MPI_Win, Win)

int MPI_Status_c2f(const MPI_Status *status, MPI_Fint *f)
{
    memcpy(f, status, sizeof *status);
    return MPI_SUCCESS;
}

int MPI_Status_f2c(const MPI_Fint *f, MPI_Status *status)
{
    memcpy(status, f, sizeof *status);
    return MPI_SUCCESS;
}
