/* mpi_languages.c - the C half of mpi_languages.f90: what each attaches to communicators, the other gets. */
#include <mpi.h>
#include <stdio.h>

static int attached = 42;

void c_attaches_(MPI_Fint *comm, MPI_Fint *key)
{
    MPI_Comm_set_attr(MPI_Comm_f2c(*comm), *key, &attached);
}

/* Fortran has got the address of what C attached. */
void c_address_(MPI_Aint *number)
{
    printf("Fortran gets C's address: %s\n", *number == (MPI_Aint)&attached ? "yes" : "no");
}

/* C gets the address of a number that Fortran attached: wide, or an INTEGER. */
void c_gets_(MPI_Fint *comm, MPI_Fint *key, MPI_Fint *wide)
{
    void *found = NULL;
    int flag = 0;
    MPI_Comm_get_attr(MPI_Comm_f2c(*comm), *key, &found, &flag);
    if (!flag)
        printf("C gets nothing\n");
    else
        printf("C gets %ld\n", *wide ? (long)*(MPI_Aint *)found : (long)*(int *)found);
}

static int copy(MPI_Comm comm, int key, void *extra, void *in, void *out, int *flag)
{
    (void)comm, (void)key, (void)extra;
    printf("C copies %d\n", *(int *)in);
    *(void **)out = &attached;
    *flag = 1;
    return MPI_SUCCESS;
}

static int drop(MPI_Comm comm, int key, void *value, void *extra)
{
    (void)comm, (void)key, (void)extra;
    printf("C deletes %d\n", *(int *)value);
    return MPI_SUCCESS;
}

void c_makes_key_(MPI_Fint *key)
{
    MPI_Comm_create_keyval(copy, drop, key, NULL);
}
