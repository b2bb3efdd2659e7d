/* linpack.c - LINPACK's order-100 benchmark as its authors wrote it: dgefa and dgesl on columns, through
 * daxpy. Compiled by nxcc -O2 with the i860's costs. */
#include <math.h>
#include "linpack.h"

static void daxpy(int n, double t, const double *x, double *y)
{
    for (int i = 0; i < n; i++)
        y[i] += t * x[i];
}

static void dscal(int n, double t, double *x)
{
    for (int i = 0; i < n; i++)
        x[i] *= t;
}

static int idamax(int n, const double *x)
{
    int at = 0;
    for (int i = 1; i < n; i++)
        if (fabs(x[i]) > fabs(x[at]))
            at = i;
    return at;
}

void linpack_matrix(double a[ORDER][ORDER], double b[ORDER])
{
    int init = 1325;
    for (int j = 0; j < ORDER; j++)
        for (int i = 0; i < ORDER; i++) {
            init = 3125 * init % 65536;
            a[j][i] = (init - 32768.0) / 16384.0;
        }
    for (int i = 0; i < ORDER; i++) {
        b[i] = 0;
        for (int j = 0; j < ORDER; j++)
            b[i] += a[j][i]; /* so that the solution is 1 */
    }
}

void linpack_factor(double a[ORDER][ORDER], int pivot[ORDER])
{
    for (int k = 0; k < ORDER - 1; k++) {
        int l = pivot[k] = k + idamax(ORDER - k, &a[k][k]);
        double t = a[k][l];
        a[k][l] = a[k][k];
        a[k][k] = t;
        dscal(ORDER - k - 1, -1.0 / t, &a[k][k + 1]);
        for (int j = k + 1; j < ORDER; j++) {
            t = a[j][l];
            a[j][l] = a[j][k];
            a[j][k] = t;
            daxpy(ORDER - k - 1, t, &a[k][k + 1], &a[j][k + 1]);
        }
    }
}

void linpack_solve(double a[ORDER][ORDER], const int pivot[ORDER], double b[ORDER])
{
    for (int k = 0; k < ORDER - 1; k++) {
        double t = b[pivot[k]];
        b[pivot[k]] = b[k];
        b[k] = t;
        daxpy(ORDER - k - 1, t, &a[k][k + 1], &b[k + 1]);
    }
    for (int k = ORDER - 1; k >= 0; k--) {
        b[k] /= a[k][k];
        daxpy(k, -b[k], a[k], b);
    }
}
