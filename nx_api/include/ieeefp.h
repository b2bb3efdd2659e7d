/* ieeefp.h - floating point as System V's library controls it: rounding, exceptions and their traps. They are
 * the processor's own, and each node's.
 *
 * A trap that is not masked ends the program with a report (SIGFPE); that of inexact results stays masked,
 * since library and simulator have those all the time.
 */
#ifndef NX_IEEEFP_H
#define NX_IEEEFP_H

typedef int fp_except;
#define FP_X_INV 0x01  /* invalid operation */
#define FP_X_DNML 0x02 /* denormalised operand */
#define FP_X_DZ 0x04   /* division by zero */
#define FP_X_OFL 0x08  /* overflow */
#define FP_X_UFL 0x10  /* underflow */
#define FP_X_IMP 0x20  /* inexact result */

typedef enum { FP_RN = 0, FP_RM = 1, FP_RP = 2, FP_RZ = 3 } fp_rnd; /* nearest, down, up, to zero */
typedef enum {
    FP_SNAN = 0,
    FP_QNAN = 1,
    FP_NINF = 2,
    FP_PINF = 3,
    FP_NDENORM = 4,
    FP_PDENORM = 5,
    FP_NZERO = 6,
    FP_PZERO = 7,
    FP_NNORM = 8,
    FP_PNORM = 9
} fpclass_t;

/* Bits of the processor's control and status word: exceptions from 0, their masks from 7, rounding from
 * 13. */
static __inline__ unsigned int nx_fp_get(void)
{
    return __builtin_ia32_stmxcsr();
}

static __inline__ unsigned int nx_fp_put(unsigned int clear, unsigned int set)
{
    unsigned int before = __builtin_ia32_stmxcsr();
    __builtin_ia32_ldmxcsr((before & ~clear) | set);
    return before;
}

static __inline__ fp_rnd fpgetround(void)
{
    return (fp_rnd)(nx_fp_get() >> 13 & 3);
}

/* All that set something return what it was. */
static __inline__ fp_rnd fpsetround(fp_rnd to)
{
    return (fp_rnd)(nx_fp_put(3u << 13, (unsigned int)to << 13) >> 13 & 3);
}

/* Of traps: those that are not masked. */
static __inline__ fp_except fpgetmask(void)
{
    return (fp_except)(~(nx_fp_get() >> 7) & 0x3f);
}

static __inline__ fp_except fpsetmask(fp_except to)
{
    return (fp_except)(~(nx_fp_put(0x3fu << 7, ((unsigned int)(~to | FP_X_IMP) & 0x3f) << 7) >> 7) & 0x3f);
}

/* Exceptions that have occurred. */
static __inline__ fp_except fpgetsticky(void)
{
    return (fp_except)(nx_fp_get() & 0x3f);
}

static __inline__ fp_except fpsetsticky(fp_except to)
{
    return (fp_except)(nx_fp_put(0x3f, (unsigned int)to & 0x3f) & 0x3f);
}

static __inline__ int isnand(double x)
{
    return __builtin_isnan(x);
}

static __inline__ fpclass_t fpclass(double x)
{
    int negative = __builtin_signbit(x) != 0;
    if (__builtin_isnan(x))
        return FP_QNAN;
    if (__builtin_isinf(x))
        return negative ? FP_NINF : FP_PINF;
    if (x == 0)
        return negative ? FP_NZERO : FP_PZERO;
    if (__builtin_isnormal(x))
        return negative ? FP_NNORM : FP_PNORM;
    return negative ? FP_NDENORM : FP_PDENORM;
}

int finite(double x);
#endif
