/* getmem.c - memory for Fortran: where it begins in an array of doubles */
char *malloc();

void getmem_(heap, n, index) double *heap;
int *n, *index;
{
    double *p = (double *)malloc(*n * sizeof(double));
    *index = p - heap + 1;
}
