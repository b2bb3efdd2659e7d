/* work.c - the inner loops of each routine: their lengths, and how often they run, by the arguments of the
 * call. Arguments are numbered from 1, as in the routine's Fortran header. */
#include "kmath.h"

static int64_t number(const struct kmath_call *c, int argument)
{
    const int *at = argument <= 6 ? c->registers[argument - 1] : c->stack[argument - 7];
    return *at > 0 ? *at : 0;
}

/* Is an argument, an option, this letter? */
static bool is(const struct kmath_call *c, int argument, char letter)
{
    const char *at = c->registers[argument - 1];
    return (*at & ~0x20) == letter;
}

static int64_t loop(const struct kmath_call *c, enum kmath_loop l, int64_t n, int64_t times)
{
    return nx_kmath_loop(c->kind, l, n, times);
}

/* A loop over the rows of each column: none runs if there are no rows. */
static int64_t columns(const struct kmath_call *c, enum kmath_loop l, int64_t rows, int64_t count)
{
    return loop(c, l, rows, rows ? count : 0);
}

/* A symmetric matrix times a vector: one half is stored, and serves twice once it is there. */
static int64_t both_halves(const struct kmath_call *c, int64_t n, int64_t times)
{
    return loop(c, KMATH_MULTIPLY, n, times) + loop(c, KMATH_PRODUCT, n, times);
}

/* --- vectors --- */

#define VECTORS(name, kernel)                                                                                \
    static int64_t name(const struct kmath_call *c)                                                          \
    {                                                                                                        \
        return loop(c, kernel, number(c, 1), 1);                                                             \
    }

VECTORS(axpy, KMATH_AXPY)
VECTORS(dot, KMATH_DOT)
VECTORS(scal, KMATH_SCAL)
VECTORS(copy, KMATH_COPY)
VECTORS(swap, KMATH_SWAP)
VECTORS(rot, KMATH_ROT)
VECTORS(asum, KMATH_ASUM)
VECTORS(nrm2, KMATH_NRM2)
VECTORS(iamax, KMATH_IAMAX)

/* --- matrices and vectors --- */

static int64_t gemv(const struct kmath_call *c) /* trans, m, n */
{
    return columns(c, KMATH_MULTIPLY, number(c, 2), number(c, 3));
}

static int64_t gbmv(const struct kmath_call *c) /* trans, m, n, kl, ku */
{
    return loop(c, KMATH_MULTIPLY, number(c, 4) + number(c, 5) + 1, number(c, 3));
}

static int64_t ger(const struct kmath_call *c) /* m, n */
{
    return columns(c, KMATH_UPDATE, number(c, 1), number(c, 2));
}

static int64_t symv(const struct kmath_call *c) /* uplo, n */
{
    return both_halves(c, number(c, 2) / 2, number(c, 2));
}

static int64_t sbmv(const struct kmath_call *c) /* uplo, n, k */
{
    return both_halves(c, number(c, 3), number(c, 2));
}

static int64_t trmv(const struct kmath_call *c) /* uplo, trans, diag, n */
{
    return loop(c, KMATH_MULTIPLY, number(c, 4) / 2, number(c, 4));
}

static int64_t tbmv(const struct kmath_call *c) /* uplo, trans, diag, n, k */
{
    return loop(c, KMATH_MULTIPLY, number(c, 5), number(c, 4));
}

static int64_t syr(const struct kmath_call *c) /* uplo, n */
{
    return loop(c, KMATH_UPDATE, number(c, 2) / 2, number(c, 2));
}

static int64_t syr2(const struct kmath_call *c) /* uplo, n */
{
    return 2 * syr(c);
}

/* --- matrices --- */

static int64_t gemm(const struct kmath_call *c) /* transa, transb, m, n, k */
{
    return columns(c, KMATH_PRODUCT, number(c, 3), number(c, 4) * number(c, 5));
}

static int64_t symm(const struct kmath_call *c) /* side, uplo, m, n */
{
    int64_t m = number(c, 3), n = number(c, 4);
    return columns(c, KMATH_PRODUCT, m, n * (is(c, 1, 'L') ? m : n));
}

static int64_t trmm(const struct kmath_call *c) /* side, uplo, trans, diag, m, n */
{
    int64_t m = number(c, 5), n = number(c, 6);
    return is(c, 1, 'L') ? loop(c, KMATH_PRODUCT, m / 2, m * n) : columns(c, KMATH_PRODUCT, m, n * n / 2);
}

static int64_t syrk(const struct kmath_call *c) /* uplo, trans, n, k */
{
    int64_t n = number(c, 3);
    return loop(c, KMATH_PRODUCT, n / 2, n * number(c, 4));
}

static int64_t syr2k(const struct kmath_call *c) /* uplo, trans, n, k */
{
    return 2 * syrk(c);
}

/* --- LAPACK's own --- */

static int64_t laswp(const struct kmath_call *c) /* n, a, lda, k1, k2 */
{
    int64_t rows = number(c, 5) - number(c, 4) + 1;
    return loop(c, KMATH_SWAP, number(c, 1), rows > 0 ? rows : 0);
}

static int64_t lacpy(const struct kmath_call *c) /* uplo, m, n */
{
    bool half = is(c, 1, 'U') || is(c, 1, 'L');
    return loop(c, KMATH_COPY, number(c, 2) >> half, number(c, 3));
}

static int64_t lascl(const struct kmath_call *c) /* type, kl, ku, cfrom, cto, m, n */
{
    return columns(c, KMATH_SCAL, number(c, 6), number(c, 7));
}

static int64_t lasr(const struct kmath_call *c) /* side, pivot, direct, m, n */
{
    int64_t m = number(c, 4), n = number(c, 5);
    return is(c, 1, 'L') ? loop(c, KMATH_ROT, n, m) : loop(c, KMATH_ROT, m, n);
}

static int64_t lange(const struct kmath_call *c) /* norm, m, n */
{
    return columns(c, KMATH_ASUM, number(c, 2), number(c, 3));
}

static int64_t lansy(const struct kmath_call *c) /* norm, uplo, n */
{
    return loop(c, KMATH_ASUM, number(c, 3) / 2, number(c, 3));
}

/* Elimination, and substitution for each right-hand side: three axpy operations for each row. */
static int64_t gtsv(const struct kmath_call *c) /* n, nrhs */
{
    return loop(c, KMATH_AXPY, number(c, 1), 3 * (1 + number(c, 2)));
}

/* --- the table --- */

#define ROUTINE(kind, name, work) work,
kmath_work *const nx_kmath_work[] = {
#include "routines.def"
};
#undef ROUTINE

#define ROUTINE(kind, name, work) KMATH_##kind,
const enum kmath_kind nx_kmath_kinds[] = {
#include "routines.def"
};
