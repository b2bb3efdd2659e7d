/* mpi_precision.c - what is known of datatypes of some precision and range: what they were made of, that they
 * are MPI's own, and which there are not. Each answer is printed. */
#include <mpi.h>
#include <stdio.h>

static int class_of(int code)
{
    int class;
    MPI_Error_class(code, &class);
    return class;
}

static void contents(const char *name, MPI_Datatype type, int combiner)
{
    int n[3], kind, ints[2] = {0};
    MPI_Type_get_envelope(type, &n[0], &n[1], &n[2], &kind);
    MPI_Type_get_contents(type, 2, 0, 0, ints, NULL, NULL);
    printf("%s: %s, %d %d %d: %d %d\n", name, kind == combiner ? "so" : "otherwise", n[0], n[1], n[2],
           ints[0], ints[1]);
}

int main(int argc, char **argv)
{
    MPI_Datatype real, complex, whole, pair, kept, other;
    double out[2] = {1.5, 2.5}, in[4] = {0};
    int count, i;
    MPI_Status status;
    MPI_Init(&argc, &argv);
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    MPI_Type_create_f90_real(7, MPI_UNDEFINED, &real);
    MPI_Type_create_f90_complex(10, 100, &complex);
    MPI_Type_create_f90_integer(9, &whole);
    contents("real", real, MPI_COMBINER_F90_REAL);
    contents("complex", complex, MPI_COMBINER_F90_COMPLEX);
    contents("integer", whole, MPI_COMBINER_F90_INTEGER);

    MPI_Type_contiguous(2, real, &pair);
    MPI_Type_commit(&pair);
    MPI_Sendrecv(out, 1, pair, 0, 1, in, 4, real, 0, 1, MPI_COMM_SELF, &status);
    MPI_Get_count(&status, real, &count);
    printf("%d received: %g %g\n", count, in[0], in[1]);
    MPI_Type_free(&pair);

    kept = real;
    printf("freed: %s\n", class_of(MPI_Type_free(&kept)) == MPI_ERR_TYPE && kept == real ? "no" : "yes");
    printf("digits: %s\n", class_of(MPI_Type_create_f90_real(34, 10, &other)) == MPI_ERR_ARG ? "no" : "yes");
    printf("range: %s\n",
           class_of(MPI_Type_create_f90_complex(3, 4932, &other)) == MPI_ERR_ARG ? "no" : "yes");
    printf("integers: %s\n", class_of(MPI_Type_create_f90_integer(39, &other)) == MPI_ERR_ARG ? "no" : "yes");
    printf("neither: %s\n",
           class_of(MPI_Type_create_f90_real(MPI_UNDEFINED, MPI_UNDEFINED, &other)) == MPI_ERR_ARG ? "no"
                                                                                                   : "yes");
    for (i = 0; i < 1000 && MPI_Type_create_f90_integer(-i, &other) == MPI_SUCCESS; i++)
        ;
    printf("at most: %d\n", i + 3);
    MPI_Finalize();
    return 0;
}
