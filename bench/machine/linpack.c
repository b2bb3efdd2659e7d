/* LINPACK, order 100, double precision, in C: Gaussian elimination by columns with partial pivoting, and the
 * solution, with the benchmark's leading dimension of 201 and its count of operations. As in the benchmark's
 * C version, the inner loops are written twice: plain, and unrolled by four in the source.
 */
#include <math.h>
#include "bench.h"

enum { N = 100, LDA = 201, ROUNDS = 4 };

static double a[N * LDA], b[N];
static long pivot[N];
static int unrolled;

static double *column(int j)
{
    return a + j * LDA;
}

static void matrix(void)
{
    int seed = 1325;
    for (int i = 0; i < N; i++)
        b[i] = 0;
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++) {
            seed = 3125 * seed % 65536;
            column(j)[i] = (seed - 32768.0) / 16384.0;
            b[i] += column(j)[i];
        }
}

static void daxpy(int n, double t, const double *x, double *y)
{
    int i = 0;
    if (n <= 0 || t == 0)
        return;
    if (unrolled) {
        for (; i < n % 4; i++)
            y[i] += t * x[i];
        for (; i < n; i += 4) {
            y[i] += t * x[i];
            y[i + 1] += t * x[i + 1];
            y[i + 2] += t * x[i + 2];
            y[i + 3] += t * x[i + 3];
        }
        return;
    }
    for (; i < n; i++)
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
    double most = fabs(x[0]);
    for (int i = 1; i < n; i++)
        if (fabs(x[i]) > most)
            at = i, most = fabs(x[i]);
    return at;
}

static void dgefa(void)
{
    for (int k = 0; k < N - 1; k++) {
        double *pk = column(k);
        int l = k + idamax(N - k, pk + k);
        double t = pk[l];
        pivot[k] = l;
        pk[l] = pk[k];
        pk[k] = t;
        dscal(N - k - 1, -1 / pk[k], pk + k + 1);
        for (int j = k + 1; j < N; j++) {
            double *pj = column(j);
            t = pj[l];
            pj[l] = pj[k];
            pj[k] = t;
            daxpy(N - k - 1, t, pk + k + 1, pj + k + 1);
        }
    }
    pivot[N - 1] = N - 1;
}

static void dgesl(void)
{
    for (int k = 0; k < N - 1; k++) {
        long l = pivot[k];
        double t = b[l];
        b[l] = b[k];
        b[k] = t;
        daxpy(N - k - 1, t, column(k) + k + 1, b + k + 1);
    }
    for (int k = N - 1; k >= 0; k--) {
        b[k] /= column(k)[k];
        daxpy(k, -b[k], column(k), b);
    }
}

static double megaflops(void)
{
    double us = 0, wrong = 0;
    for (int i = 0; i < ROUNDS; i++) {
        matrix();
        double begin = now_us();
        dgefa();
        dgesl();
        us += now_us() - begin;
    }
    for (int i = 0; i < N; i++)
        wrong = fmax(wrong, fabs(b[i] - 1));
    if (wrong > 1e-10)
        printf("wrong solution: %g\n", wrong);
    return ROUNDS * (2.0 / 3 * N * N * N + 2.0 * N * N) / us;
}

int main(void)
{
    figure("linpack_plain", megaflops());
    unrolled = 1;
    figure("linpack_unrolled", megaflops());
    return 0;
}
