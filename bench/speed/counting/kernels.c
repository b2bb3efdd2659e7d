/* kernels.c - the work of the counting benchmark, compiled by gcc (SIDE plain_PLACE) and by nxcc (SIDE
 * counted_PLACE).
 *
 * Each kernel does a fixed amount of work on its own data and returns a number that depends on all of the
 * work, so that both sides can be compared and no work is optimised away.
 */
#include <math.h>
#include <string.h>
#include "kernels.h"

static unsigned state;

static double random_double(void)
{
    state = state * 1664525u + 1013904223u;
    return (state >> 8) * (1.0 / 16777216.0);
}

/* --- Cholesky's method, 64 x 64, as for a least squares problem with full rows --- */

#define N 64

static void cholesky(double a[N][N])
{
    for (int j = 0; j < N; j++) {
        for (int k = 0; k < j; k++)
            a[j][j] -= a[j][k] * a[j][k];
        a[j][j] = sqrt(a[j][j]);
        for (int i = j + 1; i < N; i++) {
            for (int k = 0; k < j; k++)
                a[i][j] -= a[i][k] * a[j][k];
            a[i][j] /= a[j][j];
        }
    }
}

double KERNEL(cholesky)(void)
{
    static double a[N][N];
    double sum = 0;
    state = 1;
    for (int i = 0; i < N; i++)
        for (int j = 0; j <= i; j++)
            a[i][j] = i == j ? N + 1.0 : random_double();
    cholesky(a);
    for (int i = 0; i < N; i++)
        sum += a[i][i];
    return sum;
}

/* --- roots of cubics by scanning for a change of sign, then bisection (Horner and de Casteljau) --- */

static double casteljau(const double b[4], double t)
{
    double c[4];
    memcpy(c, b, sizeof c);
    for (int n = 3; n > 0; n--)
        for (int i = 0; i < n; i++)
            c[i] += t * (c[i + 1] - c[i]);
    return c[0];
}

static double horner(const double p[4], double t)
{
    double f = p[3];
    for (int i = 2; i >= 0; i--)
        f = f * t + p[i];
    return f;
}

static double bisect(const double b[4], double lo, double hi)
{
    int rising = casteljau(b, hi) > 0;
    for (int i = 0; i < 20; i++) {
        double middle = 0.5 * (lo + hi);
        if ((casteljau(b, middle) > 0) == rising)
            hi = middle;
        else
            lo = middle;
    }
    return lo;
}

double KERNEL(roots)(void)
{
    double sum = 0;
    state = 2;
    for (int n = 0; n < 200; n++) {
        double b[4], p[4];
        for (int i = 0; i < 4; i++)
            b[i] = random_double() - 0.5;
        p[0] = b[0];
        p[1] = 3 * (b[1] - b[0]);
        p[2] = 3 * (b[2] - 2 * b[1] + b[0]);
        p[3] = b[3] - 3 * b[2] + 3 * b[1] - b[0];
        double last = p[0];
        for (int i = 1; i <= 64; i++) {
            double f = horner(p, i / 64.0);
            if ((last < 0) != (f < 0))
                sum += bisect(b, (i - 1) / 64.0, i / 64.0);
            last = f;
        }
    }
    return sum;
}

/* --- slices of a sphere: a square root for each pixel --- */

double KERNEL(slices)(void)
{
    static unsigned short image[128][128];
    long sum = 0;
    for (int z = 0; z < 2; z++) {
        for (int y = 0; y < 128; y++)
            for (int x = 0; x < 128; x++)
                image[y][x] =
                    (unsigned short)(500 * sqrt((x - 63.5) * (x - 63.5) + (y - 63.5) * (y - 63.5) + z));
        sum += image[z][17];
    }
    return (double)sum;
}

/* --- LINPACK's elimination, order 100, by columns --- */

#define ORDER 100

static void daxpy(int n, double t, const double *x, double *y)
{
    for (int i = 0; i < n; i++)
        y[i] += t * x[i];
}

static int largest(int n, const double *x)
{
    int at = 0;
    for (int i = 1; i < n; i++)
        if (fabs(x[i]) > fabs(x[at]))
            at = i;
    return at;
}

double KERNEL(linpack)(void)
{
    static double a[ORDER][ORDER]; /* a[column][row] */
    double sum = 0;
    state = 3;
    for (int j = 0; j < ORDER; j++)
        for (int i = 0; i < ORDER; i++)
            a[j][i] = random_double() - 0.5;
    for (int k = 0; k < ORDER - 1; k++) {
        int l = k + largest(ORDER - k, &a[k][k]);
        double pivot = a[k][l];
        a[k][l] = a[k][k];
        a[k][k] = pivot;
        for (int i = k + 1; i < ORDER; i++)
            a[k][i] *= -1 / pivot;
        for (int j = k + 1; j < ORDER; j++) {
            double t = a[j][l];
            a[j][l] = a[j][k];
            a[j][k] = t;
            daxpy(ORDER - k - 1, t, &a[k][k + 1], &a[j][k + 1]);
        }
    }
    for (int k = 0; k < ORDER; k++)
        sum += fabs(a[k][k]);
    return sum;
}

/* --- sorting integers: short blocks, unpredictable branches --- */

static void quicksort(int *a, int lo, int hi)
{
    while (lo < hi) {
        int pivot = a[(lo + hi) / 2], i = lo, j = hi;
        while (i <= j) {
            while (a[i] < pivot)
                i++;
            while (a[j] > pivot)
                j--;
            if (i <= j) {
                int t = a[i];
                a[i++] = a[j];
                a[j--] = t;
            }
        }
        quicksort(a, lo, j);
        lo = i;
    }
}

double KERNEL(sort)(void)
{
    static int a[20000];
    state = 4;
    for (int i = 0; i < 20000; i++)
        a[i] = (int)(random_double() * 1e6);
    quicksort(a, 0, 19999);
    return a[0] + 2.0 * a[10000];
}
