// mpi_cplusplus.cc - MPI from C++: its datatypes, an operation of the program's, objects of each rank.
#include <mpi.h>
#include <complex>
#include <iostream>
#include <random>
#include <set>
#include <vector>

static std::vector<int> own; // each rank's

extern "C" void largest(void *in, void *inout, int *count, MPI_Datatype *)
{
    for (int i = 0; i < *count; i++)
        static_cast<double *>(inout)[i] =
            std::max(static_cast<double *>(inout)[i], static_cast<double *>(in)[i]);
}

int main(int argc, char **argv)
{
    MPI_Init(&argc, &argv);
    int rank, n;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &n);
    own.assign(1, rank);
    std::vector<double> x(100, rank), y(100);
    MPI_Op op;
    MPI_Op_create(largest, 1, &op);
    MPI_Allreduce(x.data(), y.data(), 100, MPI_DOUBLE, op, MPI_COMM_WORLD);
    std::complex<double> z(rank, 1), sum;
    MPI_Allreduce(&z, &sum, 1, MPI_CXX_DOUBLE_COMPLEX, MPI_SUM, MPI_COMM_WORLD);
    bool mine = rank == 1, any;
    MPI_Allreduce(&mine, &any, 1, MPI_CXX_BOOL, MPI_LOR, MPI_COMM_WORLD);
    std::random_device device; // another sequence on each rank, the same in each run
    unsigned random = device(), all[64];
    MPI_Gather(&random, 1, MPI_UNSIGNED, all, 1, MPI_UNSIGNED, 0, MPI_COMM_WORLD);
    own.push_back(rank);
    if (rank == 0)
        std::cout << y[99] << " " << sum << " " << any << " " << own.size() << " "
                  << std::set<unsigned>(all, all + n).size() << " " << all[n - 1] << std::endl;
    if (argc > 1 && rank == 1)
        std::vector<int>(2).at(rank + 1);
    MPI_Finalize();
}
