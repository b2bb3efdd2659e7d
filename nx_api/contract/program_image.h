/* image.h - the program image: the interface between a node program built by nxcc and the simulator that
 * loads it.
 *
 * A node program is a position-independent executable (ELF ET_DYN, x86-64) whose undefined symbols are all
 * named in sim/guest/exports.def. It exports one object, nxc_image, through which the simulator finds the
 * rest.
 *
 * Cost unit. Computing is counted in cost units of 1/1000 clock of the simulated processor, so that cost
 * factors near 1 can be expressed. machines/cpu/NAME.cfg gives the costs of operations in clocks.
 *
 * Counter. *left is the number of cost units that the program may still spend before the simulator wants
 * control. Each instrumented function keeps a copy of *left in a register, from which each basic block
 * subtracts its cost. The function stores the register to *left before any call that may read or change
 * *left, and loads *left again after the call.
 *
 * Poll. At loop heads and function entries the program compares the register with 0. If it is negative, the
 * poll strikes: the program stores *left, calls nxc_preempt(), and loads *left again. If the simulator last
 * set *left to B, the program has spent B - *left units since. So an event that is due after U units is seen
 * by the first poll at or past it if B = U - 1.
 *
 * Lookahead. *lookahead is the value that *left will have come down to, at the latest, when the program makes
 * its next call that the simulator serves. A poll that strikes may lower *lookahead before it calls
 * nxc_preempt() (lookahead.h). Whenever the simulator sets *left, it sets *lookahead to NXC_NO_LOOKAHEAD.
 *
 *     *left:   B ........ 0 ... -3 ............................ *lookahead
 *              control given    poll strikes                    no call before
 *
 * Profile. A program built with --profile also adds what it spends to cells (profile.h). At each call and
 * each poll that strikes, the cells are up to date with *left, and the sum over the bodies is what has been
 * spent since the program began.
 */
#ifndef NXC_IMAGE_H
#define NXC_IMAGE_H
#include <stdint.h>

#define NXC_IMAGE_MAGIC 0x54534e58u /* "TSNX" */
#define NXC_IMAGE_VERSION 4u
#define NXC_UNITS_PER_CLOCK 1000
#define NXC_NO_LOOKAHEAD (INT64_MAX / 2)
/* The largest data cache and translation buffer that can be simulated: cache.h. */
enum { NXC_CACHE_SETS = 1024, NXC_TLB_SETS = 64, NXC_CACHE_WAYS = 4, NXC_CACHE_SET_BYTES = 32 };

/* The units spent in the body of one function, with all that is inlined into it; or in a part of a body: in
 * what is inlined from one other function, or in one library function. A function has spent the sum of the
 * cells with its name, less the sum of the parts of its bodies. */
struct nxc_cell {
    int64_t units;
    const char *file, *function; /* of the source */
    const char *called;          /* the library function, NULL: none */
    struct nxc_cell *body;       /* the cell of which this is a part, NULL: this is a body */
    int64_t line;                /* of the function */
};

struct nxc_image {
    uint32_t magic;
    uint32_t version;
    int64_t *left;                      /* the counter */
    int64_t *lookahead;                 /* the lookahead's end, as a value of *left */
    int (*main)(int, char **, char **); /* the program */
    void (**init_begin)(void);          /* constructors, run on the node before main */
    void (**init_end)(void);
    struct nxc_cell *cells_begin; /* both NULL: built without --profile */
    struct nxc_cell *cells_end;
    int64_t long_bytes; /* the size of long in C: 8, or 4 (nxcc --long32) */
};

/* Served by the simulator: lets virtual time catch up with the program, and returns with *left set anew. */
void nxc_preempt(void);
#endif
