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
 * Unit. One unit is 1/1000 clock of the simulated processor, so that cost factors near one can be expressed;
 * class costs are whole or fractional clocks in machines/cpu/.cfg files.
 */
#ifndef NXC_IMAGE_H
#define NXC_IMAGE_H
#include <stdint.h>

#define NXC_IMAGE_MAGIC 0x54534e58u /* "TSNX" */
#define NXC_IMAGE_VERSION 1u
#define NXC_UNITS_PER_CLOCK 1000
#define NXC_CACHE_LINES 4096 /* at most, of a simulated data cache: cache.h */

struct nxc_image {
    uint32_t magic;
    uint32_t version;
    int64_t *left;                      /* the program's own counter, see above */
    int (*main)(int, char **, char **); /* the program */
    void (**init_begin)(void);          /* constructors, run on the node before main */
    void (**init_end)(void);
};

/* Served by the simulator: let virtual time catch up; returns with *left set anew. */
void nxc_preempt(void);
#endif
