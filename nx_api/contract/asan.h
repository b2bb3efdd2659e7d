/* asan.h - what a program built with nxcc --asan and the simulator agree upon, so that accesses outside of
 * the memory that the program has are found (Serebryany & al., "AddressSanitizer", USENIX ATC 2012).
 *
 * Each 8 bytes of the program's memory have a byte of shadow, which the simulator keeps:
 *
 *     shadow of an address  =  (address - low) / 8  bytes behind `shadow`
 *     0: all 8 bytes are the program's;  1 ... 7: only so many;  enum nxc_asan_shadow: none
 *
 * The plugin (nxcc/checks/race_pass.h) puts before each load and store that may go wrong
 *
 *     if (address - low >= bytes || one of the access's bytes of shadow is not 0)
 *         nxc_race_access(address, &site);
 *
 * and nxc_race_range() at calls of library functions, as for --races (races.h). NX's calls are looked at by
 * the simulator itself.
 *
 * Around objects lie red zones, which are nobody's: behind each variable of a file
 * (nxcc/checks/asan_globals.h) and each local array or variable whose address is taken
 * (nxcc/checks/asan_locals.h), behind each block of alloca, and on both sides of a block of the heap
 * (sim/asan). */
#ifndef CONTRACT_ASAN_H
#define CONTRACT_ASAN_H
#include <stddef.h>
#include <stdint.h>

enum { NXC_ASAN_GRAIN = 8, NXC_ASAN_ZONE = 32 }; /* bytes; of a variable's red zone, at least */

/* Why memory is not the program's. */
enum nxc_asan_shadow {
    NXC_ASAN_LOCAL = 0xf3,
    NXC_ASAN_RETURNED =
        0xf5, /* variables of a function that has returned, unless the stack is in use there */
    NXC_ASAN_GLOBAL = 0xf9,
    NXC_ASAN_HEAP = 0xfa,
    NXC_ASAN_FREED = 0xfd,
    NXC_ASAN_OTHERS = 0xfe /* other nodes' memory */
};

/* How far behind the beginning of a local variable, or a block of alloca, its red zone begins: at the first
 * multiple of 8. */
static inline size_t nxc_asan_zone_at(size_t bytes)
{
    return (bytes + NXC_ASAN_GRAIN - 1) / NXC_ASAN_GRAIN * NXC_ASAN_GRAIN;
}

/* What the red zone behind a local variable holds, from its 16th byte on: whose it is. */
enum { NXC_ASAN_LOCAL_AT = 16 };
struct nxc_asan_local {
    const struct nxc_race_site *site; /* where the variable is declared: races.h */
    uint64_t bytes;
};

/* A variable of a file, with a red zone behind it. The address and the texts are so many bytes from the
 * member, or from the entry's beginning. */
struct nxc_asan_global {
    int64_t at;
    uint64_t bytes;
    int32_t name, file;
    int32_t line;
    int32_t common; /* several files may define it: the linker takes the largest */
};

/* Of the program: struct nxc_races.asan; NULL: no file of it was built with --asan. The simulator sets the
 * first three; until then bytes is 0, and the simulator is told of each access, and ignores it. */
struct nxc_asan {
    uintptr_t *low, *bytes;
    uint8_t **shadow;
    const struct nxc_asan_global *globals_begin, *globals_end; /* of all files */
};
#endif
