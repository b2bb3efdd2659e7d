/* kmath.h - libkmath.a: the reference BLAS and LAPACK of Debian's libblas-dev and liblapack-dev, whose work
 * is counted.
 *
 * Debian's objects are machine code that counts nothing. So each routine that routines.def lists is renamed
 * (nx_kmath_NAME_), and its name becomes an entry (entry.c) that first pays for the work (pay.c), then goes
 * on with the routine. LAPACK's routines call these entries, too. What is paid: so many times one of the
 * inner loops that the reference's Fortran sources have (work.c), each at what nxcc counts for the same loop
 * (kernels.c). Handlers run while a routine is paid for, before it has changed anything.
 *
 * Standing: derived. Loops of a triangle count with their mean length, strides other than 1 as 1, and
 * elements that are 0, which the reference skips, as any. LAPACK's loops outside of these routines are not
 * counted: of order n or n^2 where the work is of order n^3; the iterations for eigenvalues (xSTEQR, xHSEQR)
 * and narrow-banded solvers are the exceptions that matter.
 */
#ifndef KMATH_H
#define KMATH_H
#include <stdbool.h>
#include <stdint.h>

enum kmath_kind { KMATH_s, KMATH_d, KMATH_c, KMATH_z, KMATH_KINDS };

enum kmath_loop {
    KMATH_AXPY, /* y(i) = y(i) + a * x(i) */
    KMATH_DOT,
    KMATH_SCAL,
    KMATH_COPY,
    KMATH_SWAP,
    KMATH_ROT,
    KMATH_ASUM,
    KMATH_NRM2,
    KMATH_IAMAX,
    KMATH_LOOPS
};

/* A call: the addresses of its arguments, the first six and the others. */
struct kmath_call {
    const void *const *registers;
    const void *const *stack;
    enum kmath_kind kind;
};

/* Runs an inner loop over n elements of vectors, each with room for 100 of any kind; counted. */
void nx_kmath_kernel(enum kmath_kind kind, enum kmath_loop loop, int n, void *x, void *y);

/* Units of a loop over n elements, done `times` times. */
int64_t nx_kmath_loop(enum kmath_kind kind, enum kmath_loop loop, int64_t n, int64_t times);

/* Units of a call, one function for each WORK of routines.def. */
typedef int64_t kmath_work(const struct kmath_call *c);
extern kmath_work *const nx_kmath_work[];
extern const enum kmath_kind nx_kmath_kinds[];

/* What the entries call: the routine's number in routines.def. */
void nx_kmath_pay(int routine, const void *const *registers, const void *const *stack);
#endif
