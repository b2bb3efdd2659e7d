/* races.h - what a program built with nxcc --races tells the simulator of its accesses to memory, so that
 * races between handlers and the code that they interrupt are found.
 *
 * The plugin (nxcc/checks/race_pass.h) puts before each load and store that may concern memory which others
 * can reach:
 *
 *     if (nxc_races_on)                         a byte of the program, which the simulator sets
 *         nxc_race_access(address, &site);
 *
 * and nxc_race_range() at calls of library functions that read or write memory (memcpy, read ...): before the
 * call, or behind it if only the call knows how much it has written (sprintf). NX's own calls (crecv, csend
 * ...) are left out: the simulator knows itself what they touch. Local variables whose address is never taken
 * are left out, too. The instrumentation changes no cost: the program spends what it spends without --races.
 *
 * What a site tells is constant, and lies in a table of the compiled file. */
#ifndef CONTRACT_RACES_H
#define CONTRACT_RACES_H
#include <stddef.h>
#include <stdint.h>

enum nxc_race_flags {
    NXC_RACE_WRITE = 1,    /* otherwise a read */
    NXC_RACE_VOLATILE = 2, /* of a volatile object */
    /* The value read decides whether a loop goes on that changes nothing else the condition depends on: the
     * program waits for somebody to change it (Jannesari & Tichy, "Identifying ad-hoc synchronization for
     * enhanced race detection", IPDPS 2010). */
    NXC_RACE_SPIN = 4,
    NXC_RACE_IGNORE = 8, /* the source says so: a comment "nxcc: race-ok" on the line or the line before */
    NXC_RACE_GIVEN =
        16, /* no access, and never told: a call on the line is given a pointer to the variable */
    /* No access: it says that the write of the same volatile variable that follows gives it a value that was
     * computed from a read of it. */
    NXC_RACE_UPDATE = 32,
    NXC_RACE_LOCAL = 64 /* no access: where a local variable is declared (asan.h) */
};

/* A place in the source that accesses memory. A text lies so many bytes behind the site's own beginning, so
 * that nothing is relocated, and all nodes share one table: nxc_race_text. */
struct nxc_race_site {
    int32_t file, function;
    int32_t variable; /* as in the source, "queue[i].next"; "": not known */
    int32_t line;
    uint16_t bytes; /* of one access; 0: given at run time */
    uint16_t flags; /* enum nxc_race_flags */
};

static inline const char *nxc_race_text(const struct nxc_race_site *site, int32_t text)
{
    return (const char *)site + text;
}

struct nxc_asan; /* asan.h */

/* Of the program: struct nxc_image.races; NULL: no file of it was built with --races or --asan. */
struct nxc_races {
    uint8_t *on; /* the simulator sets it to 1 where accesses are to be told */
    const struct nxc_race_site *sites_begin, *sites_end; /* of all files, one behind the other */
    const struct nxc_asan *asan;                         /* NULL: no file was built with --asan */
};

/* Served by the simulator; not calls of the program: they take no virtual time and end no lookahead. The
 * counter may be in a register of the program, so that *left tells only where the program was at its last
 * poll or call. The caller has saved the general and the SSE registers, but not the x87's: no long double.
 * A range without a site: an exception is about to end frames, so that the red zones of their variables are
 * to be forgotten. */
void nxc_race_access(const void *address, const struct nxc_race_site *site);
void nxc_race_range(const void *address, size_t bytes, const struct nxc_race_site *site);
#endif
