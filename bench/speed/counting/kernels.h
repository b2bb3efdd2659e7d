/* kernels.h - the kernels of the counting benchmark; each exists as plain_NAME and counted_NAME. */
#ifndef KERNELS_H
#define KERNELS_H
#define KERNELS(K) K(cholesky) K(roots) K(slices) K(linpack) K(sort)
#define APP_KERNELS(K) K(app_slice) K(app_c3) K(app_fit) K(app_trilinear) K(app_tricubic)

#define JOIN_(a, b) a##_##b
#define JOIN(a, b) JOIN_(a, b)
#define KERNEL(name) JOIN(SIDE, name)

#ifdef SIDE
#define DECLARE(name) double KERNEL(name)(void);
KERNELS(DECLARE)
APP_KERNELS(DECLARE)
#undef DECLARE
#endif
#endif
