/* kmath.h - libkmath.a: the reference BLAS and LAPACK of Debian's libblas-dev and liblapack-dev, whose work
 * is counted.
 *
 * Debian's objects are machine code that counts nothing. So each routine in routines.def gets another name,
 * nx_kmath_NAME_, and its own name becomes an entry point (entry.c) that first charges the program for the
 * work (pay.c) and then jumps to the routine. LAPACK's routines call these entry points, too. The charge is
 * the sum over the inner loops (work.c) of how often a loop runs times the cost of the loop. Handlers
 * run while a routine is charged, before the routine has changed anything.
 *
 * The library of the time was written in assembler, in dual-instruction mode: loops.c prices a loop by the
 * accesses to memory and the pipelines of the i860, and by its data cache. Two loops that were not (norms,
 * searches) cost what nxcc counts for them (kernels.c).
 *
 * Standing: derived. Loops of a triangle are charged with their mean length, strides other than 1 as 1, and
 * elements that are 0, which the reference skips, as any other. LAPACK's loops outside of these routines are
 * not counted: they are of order n or n^2 where the work is of order n^3. Exceptions that matter are the
 * iterations for eigenvalues (xSTEQR, xHSEQR) and the solvers of narrow bands.
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
    KMATH_MULTIPLY,  /* a matrix's column with a vector that stays in registers or cache */
    KMATH_UPDATE,    /* a vector is added to a matrix's column */
    KMATH_PRODUCT,   /* of matrices, by blocks that stay there */
    KMATH_ASSEMBLER, /* so many in assembler; the others are compiled */
    KMATH_NRM2 = KMATH_ASSEMBLER,
    KMATH_IAMAX,
    KMATH_LOOPS
};

/* A call: the addresses of its first six arguments and of the others, and the kind of elements. */
struct kmath_call {
    const void *const *registers;
    const void *const *stack;
    enum kmath_kind kind;
};

/* Runs an inner loop over n elements of vectors, each with room for 100 elements of any kind. Counted. */
void nx_kmath_kernel(enum kmath_kind kind, enum kmath_loop loop, int n, void *x, void *y);

/* The cost units of a loop over n elements that runs `times` times: of any, and of one in assembler. */
int64_t nx_kmath_loop(enum kmath_kind kind, enum kmath_loop loop, int64_t n, int64_t times);
int64_t nx_kmath_assembler(enum kmath_kind kind, enum kmath_loop loop, int64_t n, int64_t times);

/* The cost units of a call: one function for each WORK of routines.def. */
typedef int64_t kmath_work(const struct kmath_call *c);
extern kmath_work *const nx_kmath_work[];
extern const enum kmath_kind nx_kmath_kinds[];

/* Charges a call. Called by the entry points. routine: the routine's number in routines.def. */
void nx_kmath_pay(int routine, const void *const *registers, const void *const *stack);
#endif
