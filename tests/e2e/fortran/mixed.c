/* mixed.c - C and Fortran in one program: each calls the other, and both print. */
#include <nx.h>
#include <stdio.h>
#include <string.h>
extern int twice_(const int *n);
extern struct {
    int count;
    double sum;
} totals_;

void store_(const char *text, const double *x, size_t bytes)
{
    totals_.count++;
    totals_.sum += *x;
    printf("C has %.*s %g\n", (int)bytes, text, *x);
}

int main(void)
{
    extern void compute_(void);
    int n = 21;
    if (mynode() == 0)
        printf("Fortran makes %d of it\n", twice_(&n));
    gsync();
    if (mynode() == 1)
        compute_();
    return 0;
}
