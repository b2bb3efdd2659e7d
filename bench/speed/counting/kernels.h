/* kernels.h - the kernels of the counting benchmark. Each exists as plain_PLACE_NAME and counted_PLACE_NAME
 * for each of the places of counting.mk. */
#ifndef KERNELS_H
#define KERNELS_H
#define KERNELS(K)                                                                                           \
    K(cholesky)                                                                                              \
    K(roots)                                                                                                 \
    K(slices)                                                                                                \
    K(linpack)                                                                                               \
    K(sort)                                                                                                  \
    K(f_linpack)                                                                                             \
    K(f_sort)                                                                                                \
    K(f_forces)                                                                                              \
    K(app_slice)                                                                                             \
    K(app_c3)                                                                                                \
    K(app_fit)                                                                                               \
    K(app_trilinear)                                                                                         \
    K(app_tricubic)

#define JOIN_(a, b) a##_##b
#define JOIN(a, b) JOIN_(a, b)
#define KERNEL(name) JOIN(SIDE, name)

#ifdef SIDE
#define DECLARE(name) double KERNEL(name)(void);
KERNELS(DECLARE)
#undef DECLARE
#endif
#endif
