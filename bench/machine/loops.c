/* Loops in which numerical programs spend most of their time, in cache and out of cache: millions of
 * floating-point operations a second on one node.
 */
#include "bench.h"

enum { SMALL = 200, LARGE = 100000, ORDER = 64, SIDE = 200 };

static double x[LARGE], y[LARGE], a[ORDER][ORDER], b[ORDER][ORDER], c[ORDER][ORDER], grid[2][SIDE][SIDE];
static volatile double sink;

static void daxpy(int n, double t)
{
    for (int i = 0; i < n; i++)
        y[i] += t * x[i];
}

static void daxpy_unrolled(int n, double t)
{
    for (int i = 0; i < n; i += 4) {
        y[i] += t * x[i];
        y[i + 1] += t * x[i + 1];
        y[i + 2] += t * x[i + 2];
        y[i + 3] += t * x[i + 3];
    }
}

void daxpy_(const int *n, const double *t, const double *x, const int *x_step, double *y, const int *y_step);

static void daxpy_library(int n, double t) /* by hand: -lkmath */
{
    const int one = 1;
    daxpy_(&n, &t, x, &one, y, &one);
}

static void ddot(int n, double t)
{
    double sum = t;
    for (int i = 0; i < n; i++)
        sum += y[i] * x[i];
    sink = sum;
}

/* A polynomial of degree 8 for each element. */
static void polynomial(int n, double t)
{
    for (int i = 0; i < n; i++) {
        double s = t;
        for (int k = 0; k < 8; k++)
            s = s * x[i] + 0.5;
        y[i] = s;
    }
}

static void multiply(int n, double t)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double sum = t;
            for (int k = 0; k < n; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
    sink = c[n / 2][n / 2];
}

static void relax(int n, double t)
{
    for (int i = 1; i < n - 1; i++)
        for (int j = 1; j < n - 1; j++)
            grid[1][i][j] =
                t * (grid[0][i - 1][j] + grid[0][i + 1][j] + grid[0][i][j - 1] + grid[0][i][j + 1]);
    sink = grid[1][n / 2][n / 2];
}

/* Elimination along a line, forwards and back, as in implicit methods. */
static void tridiagonal(int n, double t)
{
    for (int i = 1; i < n; i++)
        y[i] -= t * x[i - 1] * y[i - 1];
    for (int i = n - 2; i >= 0; i--)
        y[i] = (y[i] - t * y[i + 1]) * x[i];
}

static void measure(const char *name, void (*loop)(int n, double t), int n, int times, double operations)
{
    loop(n, 0.25);
    double begin = now_us();
    for (int i = 0; i < times; i++)
        loop(n, 0.25);
    figure(name, operations * times / (now_us() - begin));
}

int main(void)
{
    for (int i = 0; i < LARGE; i++)
        x[i] = 0.5, y[i] = 1.0 / (i + 1);
    for (int i = 0; i < ORDER; i++)
        for (int j = 0; j < ORDER; j++)
            a[i][j] = i + j, b[i][j] = i - j;
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++)
            grid[0][i][j] = i ^ j;
    measure("daxpy_in_cache", daxpy, SMALL, 500, 2.0 * SMALL);
    measure("daxpy_out_of_cache", daxpy, LARGE, 1, 2.0 * LARGE);
    measure("daxpy_library_out_of_cache", daxpy_library, LARGE, 1, 2.0 * LARGE);
    measure("daxpy_unrolled_in_cache", daxpy_unrolled, SMALL, 500, 2.0 * SMALL);
    measure("daxpy_unrolled_out_of_cache", daxpy_unrolled, LARGE, 1, 2.0 * LARGE);
    measure("ddot", ddot, SMALL, 500, 2.0 * SMALL);
    measure("polynomial", polynomial, SMALL, 100, 16.0 * SMALL);
    measure("matrix_multiply", multiply, ORDER, 1, 2.0 * ORDER * ORDER * ORDER);
    measure("relaxation", relax, SIDE, 2, 4.0 * (SIDE - 2) * (SIDE - 2));
    measure("tridiagonal", tridiagonal, SMALL, 100, 6.0 * SMALL);
    return 0;
}
