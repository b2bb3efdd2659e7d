/* loops.c - what inner loops in an i860's assembler cost. Standing of each figure: known, from the i860
 * Programmer's Reference Manual (PRM), or derived.
 *
 * In dual-instruction mode a core instruction and a floating-point instruction begin at each clock. The core
 * loads and stores an element a clock, and has one clock more for the loop. The pipelines take a
 * multiplication of single precision a clock, of double precision one in two, and an addition beside it
 * (known, PRM). The longer of both is what an element takes.
 *
 * If a loop's elements do not fit in the data cache, each line comes from memory and, where it was changed,
 * goes back there. A store to a line that was not loaded goes to memory by itself. The log of a Paragon of
 * 1995 has 3.0 clocks for an element of dscal in cache, 12.2 of daxpy and 11.1 of dcopy out of it; these
 * figures make 3.0, 11.5 and 9.8. */
#include "../contract/program_image.h"
#include "kmath.h"

enum {
    LINE = 32,      /* known, PRM: bytes */
    LOAD = 11,      /* known, PRM: 10-14 in all, 12 taken, less the load that waits: clocks a line */
    WRITE_BACK = 8, /* derived: four writes of 8 bytes, one in two clocks (known, PRM): clocks a line */
    STORE = 16,     /* known, PRM: 2-8 a store in all, 5 taken, less the hit's 1, four times: clocks a line */
    START_CALL = 30, /* open: a call, and pipelines that fill: clocks */
    START_LOOP = 8   /* open: of a loop over the columns of a matrix */
};

extern int64_t nxc_data_cache __attribute__((visibility("hidden")));

static const struct assembler {
    int loads, stores, fresh; /* of elements; fresh: stores of elements that are not loaded before */
    int multiplications, additions;
} ASSEMBLER[] = {
    [KMATH_AXPY] = {2, 1, 0, 1, 1},    [KMATH_DOT] = {2, 0, 0, 1, 1},      [KMATH_SCAL] = {1, 1, 0, 1, 0},
    [KMATH_COPY] = {1, 1, 1, 0, 0},    [KMATH_SWAP] = {2, 2, 0, 0, 0},     [KMATH_ROT] = {2, 2, 0, 4, 2},
    [KMATH_ASUM] = {1, 0, 0, 0, 1},    [KMATH_MULTIPLY] = {1, 0, 0, 1, 1}, [KMATH_UPDATE] = {1, 1, 0, 1, 1},
    [KMATH_PRODUCT] = {0, 0, 0, 1, 1},
};

static int64_t larger(int64_t a, int64_t b)
{
    return a > b ? a : b;
}

/* Clocks an element in the cache. A complex multiplication is four and two additions. */
static int64_t near(enum kmath_kind kind, const struct assembler *a)
{
    bool complex = kind == KMATH_c || kind == KMATH_z, twice = kind == KMATH_d || kind == KMATH_z;
    int64_t core = (a->loads + a->stores) * (complex ? 2 : 1) + 1;
    int64_t multiplications = a->multiplications * (complex ? 4 : 1) * (twice ? 2 : 1);
    int64_t additions = complex ? 2 * (a->additions + a->multiplications) : a->additions;
    return larger(core, larger(multiplications, additions));
}

int64_t nx_kmath_assembler(enum kmath_kind kind, enum kmath_loop loop, int64_t n, int64_t times)
{
    static const int BYTES[KMATH_KINDS] = {4, 8, 8, 16};
    const struct assembler *a = &ASSEMBLER[loop];
    int64_t elements = n * times, start = times > 1 ? START_LOOP : START_CALL;
    int64_t units = NXC_UNITS_PER_CLOCK * (times * start + elements * near(kind, a));
    int64_t line = a->loads * LOAD + (a->stores - a->fresh) * WRITE_BACK + a->fresh * STORE;
    if (elements * (a->loads + a->fresh) * BYTES[kind] > nxc_data_cache)
        units += elements * BYTES[kind] * line * NXC_UNITS_PER_CLOCK / LINE;
    return units;
}
