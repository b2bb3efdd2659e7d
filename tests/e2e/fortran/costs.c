/* costs.c - the same loops in C and Fortran: prints what each takes, Fortran's in thousandths of C's. */
#include <nx.h>
#include <stdio.h>

enum { N = 300 };
extern void axpy_(int *n, double *a, double *x, double *y), pairs_(int *n, double *x, double *f),
    count_(int *n, int *k);

static double x[N], y[3 * N], f[3 * N];
static int keys[N];

__attribute__((noipa)) static void axpy(int n, double a, const double *u, double *v)
{
    for (int i = 0; i < n; i++)
        v[i] += a * u[i];
}

__attribute__((noipa)) static void pairs(int n, const double *restrict p, double *restrict force)
{
    for (int i = 1; i < n; i++)
        for (int j = 0; j < i; j++) {
            double d = p[i] - p[j];
            if (d * d < 0.3) {
                double r = 1 / (d * d + 0.01), s = r * r * r;
                force[i] += d * s * (s - 0.5);
                force[j] -= d * s * (s - 0.5);
            }
        }
}

__attribute__((noipa)) static void count(int n, int *restrict k)
{
    for (int i = 0; i < n; i++)
        k[(i * 37) % n] += i / 3;
}

static void compare(const char *name, double c, double fortran)
{
    printf("%s %.0f\n", name, 1000 * fortran / c);
}

int main(void)
{
    int n = N;
    double a = 2, t[3];
    for (int i = 0; i < N; i++)
        x[i] = (i * 7919 % N) / (double)N;
    t[0] = dclock(), axpy(n, a, x, y), t[1] = dclock(), axpy_(&n, &a, x, y), t[2] = dclock();
    compare("axpy", t[1] - t[0], t[2] - t[1]);
    t[0] = dclock(), pairs(n, x, f), t[1] = dclock(), pairs_(&n, x, f), t[2] = dclock();
    compare("pairs", t[1] - t[0], t[2] - t[1]);
    t[0] = dclock(), count(n, keys), t[1] = dclock(), count_(&n, keys), t[2] = dclock();
    compare("count", t[1] - t[0], t[2] - t[1]);
    return 0;
}
