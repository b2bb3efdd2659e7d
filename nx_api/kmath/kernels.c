/* kernels.c - the inner loops of the reference BLAS that are priced as compiled, as its Fortran sources have
 * them. nxcc compiles them, so that they are counted like a program's own loops. They run on a few elements,
 * to measure their cost. */
#include "kmath.h"

#define KERNELS(T, kind, magnitude)                                                                          \
    static void nrm2_##kind(int n, T *x, T *y)                                                               \
    {                                                                                                        \
        T sum = 0;                                                                                           \
        for (int i = 0; i < n; i++)                                                                          \
            if (magnitude(x[i]) < 1e10f)                                                                     \
                sum += x[i] * x[i];                                                                          \
        y[n] = sum;                                                                                          \
    }                                                                                                        \
    static void iamax_##kind(int n, T *x, T *y)                                                              \
    {                                                                                                        \
        int at = 0;                                                                                          \
        for (int i = 0; i < n; i++)                                                                          \
            if (magnitude(x[i]) > magnitude(x[at]))                                                          \
                at = i;                                                                                      \
        y[n] = (T)at;                                                                                        \
    }                                                                                                        \
    static void run_##kind(enum kmath_loop loop, int n, void *x, void *y)                                    \
    {                                                                                                        \
        (loop == KMATH_NRM2 ? nrm2_##kind : iamax_##kind)(n, x, y);                                          \
    }

#define COMPLEX_MAGNITUDE(x) (__builtin_fabsf(__real__(x)) + __builtin_fabsf(__imag__(x)))
#define DOUBLE_COMPLEX_MAGNITUDE(x) (__builtin_fabs(__real__(x)) + __builtin_fabs(__imag__(x)))

/* As GNU Fortran does: complex numbers are multiplied without a test for infinities. */
#pragma GCC optimize("cx-fortran-rules")
KERNELS(float, s, __builtin_fabsf)
KERNELS(double, d, __builtin_fabs)
KERNELS(_Complex float, c, COMPLEX_MAGNITUDE)
KERNELS(_Complex double, z, DOUBLE_COMPLEX_MAGNITUDE)

void nx_kmath_kernel(enum kmath_kind kind, enum kmath_loop loop, int n, void *x, void *y)
{
    static void (*const kinds[KMATH_KINDS])(enum kmath_loop, int, void *, void *) = {run_s, run_d, run_c,
                                                                                     run_z};
    kinds[kind](loop, n, x, y);
}
