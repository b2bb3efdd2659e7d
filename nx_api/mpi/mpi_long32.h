/* mpi_long32.h - what a program whose long has 32 bits (nxcc --mpi --long32) finds otherwise than others. */
#ifndef MPI_LONG32_H
#define MPI_LONG32_H

typedef int main_function(int argc, char **argv, char **envp);
/* Calls the program's main, where it may keep addresses of its stack and heap in ints. */
int mpi_call_main(main_function *program, int argc, char **argv, char **envp);

#endif
