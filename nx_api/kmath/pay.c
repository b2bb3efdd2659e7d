/* pay.c - charges a node's program for a routine's work. Not counted itself: it takes the work's cost units
 * from the program's counter (contract/program_image.h), 1,000 clocks at a time, so that handlers run at
 * their times. */
#include "../contract/program_image.h"
#include "../nxcc/runtime/enter.h"
#include "kmath.h"

enum { PIECE = 1000 * NXC_UNITS_PER_CLOCK, FEW = 8, MORE = 40, ROOM = 100 };

extern int64_t nxc_left __attribute__((visibility("hidden")));

struct price {
    int64_t base, element; /* units; element 0: not measured yet */
};

/* The cost units that a kernel counts, without charging them to the program. */
static int64_t count(enum kmath_kind kind, enum kmath_loop loop, int n)
{
    static double x[2 * ROOM], y[2 * ROOM];
    const int64_t left = nxc_left, plenty = INT64_MAX / 4;
    nxc_left = plenty;
    nx_kmath_kernel(kind, loop, n, x, y);
    int64_t units = plenty - nxc_left;
    nxc_left = left;
    return units;
}

int64_t nx_kmath_loop(enum kmath_kind kind, enum kmath_loop loop, int64_t n, int64_t times)
{
    static struct price prices[KMATH_KINDS][KMATH_LOOPS];
    struct price *p = &prices[kind][loop];
    if (loop < KMATH_ASSEMBLER)
        return nx_kmath_assembler(kind, loop, n, times);
    if (!p->element) {
        int64_t few = count(kind, loop, FEW), more = count(kind, loop, MORE);
        p->element = (more - few) / (MORE - FEW);
        p->base = few - FEW * p->element;
    }
    return times * (p->base + n * p->element);
}

void nx_kmath_pay(int routine, const void *const *registers, const void *const *stack)
{
    struct kmath_call call = {registers, stack, nx_kmath_kinds[routine]};
    for (int64_t units = nx_kmath_work[routine](&call); units > 0; units -= PIECE) {
        nxc_left -= units < PIECE ? units : PIECE;
        if (nxc_left < 0)
            __asm__ volatile(NXC_CALL_ENTER ::
                                 : "memory", "cc", "st", "st(1)", "st(2)", "st(3)", "st(4)", "st(5)", "st(6)",
                                   "st(7)");
    }
}
