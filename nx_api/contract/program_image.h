/* image.h - the contract between a node program built by nxcc and the simulator that loads it.
 *
 * A node program is a position-independent executable (ELF ET_DYN, x86-64) whose undefined symbols are all
 * named in sim/node/exports.def. It exports one object, nxc_image, through which the simulator finds the
 * rest.
 *
 * Counting. The plugin keeps, in every instrumented function, a register copy of *left, the cost units that
 * may still be spent before the simulator wants control. Every basic block subtracts its cost. The register
 * is stored to *left before any call that may look at it or change it, and reloaded after. At loop headers
 * and function entries a negative value makes the program store it and call nxc_preempt(), and reload. units
 * spent since the simulator last set *left to B  =  B - *left so an event that is due after U units is seen
 * at the first check at or past it when B = U - 1.
 *
 * Quiet. A program whose check strikes may have put into *quiet what *left will have come to, at most, when it makes its next
 * call that the simulator serves, as far as it knows (promise.h). The simulator sets *quiet to NXC_NOT_QUIET whenever it sets
 * *left.
 *
 * Profile. A program built with --profile adds what it spends to cells as well (how: profile.h). At any call
 * and check the cells are up to date with *left, and the bodies' sum is what was spent since the program
 * began.
 *
 * Unit. One unit is 1/1000 clock of the simulated processor, so that cost factors near one can be expressed;
 * class costs are whole or fractional clocks in machines/cpu/.cfg files.
 */
#ifndef NXC_IMAGE_H
#define NXC_IMAGE_H
#include <stdint.h>

#define NXC_IMAGE_MAGIC 0x54534e58u /* "TSNX" */
#define NXC_IMAGE_VERSION 4u
#define NXC_UNITS_PER_CLOCK 1000
#define NXC_NOT_QUIET (INT64_MAX / 2)
/* At most, of a simulated data cache and translation buffer: cache.h. */
enum { NXC_CACHE_SETS = 1024, NXC_TLB_SETS = 64, NXC_CACHE_WAYS = 4, NXC_CACHE_SET_BYTES = 32 };

/* Units spent in one function's body, all that was inlined into it included; or in a part of a body: what was
 * inlined from one other function, or one library call. So what a function has spent is the sum over the cells
 * with its name, less the sum over the parts of its bodies. */
struct nxc_cell {
    int64_t units;
    const char *file, *function; /* where it was written */
    const char *called;          /* the library function it was spent in, NULL: none */
    struct nxc_cell *body;       /* it is a part of this one, NULL: it is a body */
    int64_t line;                /* of the function */
};

struct nxc_image {
    uint32_t magic;
    uint32_t version;
    int64_t *left;                      /* the program's own counter, see above */
    int64_t *quiet;                     /* it makes no call before *left is less than this */
    int (*main)(int, char **, char **); /* the program */
    void (**init_begin)(void);          /* constructors, run on the node before main */
    void (**init_end)(void);
    struct nxc_cell *cells_begin; /* both NULL: built without --profile */
    struct nxc_cell *cells_end;
    int64_t long_bytes; /* of a C program's long: 8, or 4 (nxcc --long32) */
};

/* Served by the simulator: let virtual time catch up; returns with *left set anew. */
void nxc_preempt(void);
#endif
