/* linpack.h - see linpack.c. a[column][row]. */
#ifndef LINPACK_H
#define LINPACK_H
enum { ORDER = 100 };
void linpack_matrix(double a[ORDER][ORDER], double b[ORDER]);
void linpack_factor(double a[ORDER][ORDER], int pivot[ORDER]);
void linpack_solve(double a[ORDER][ORDER], const int pivot[ORDER], double b[ORDER]);
#endif
