/* program_image.h - the interface between a node program built by nxcc and the simulator that loads it: the
 * program image.
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
 * poll strikes: the program stores *left, calls nxc_preempt, and loads *left again. If the simulator last
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
 * Profile. A program built with --profile also counts what it spends by path of calls (profile.h). At each
 * call and each poll that strikes, the counts are up to date with *left. *path is then the path of the
 * function that calls. Whoever calls a function of the program sets *path to the caller's path before.
 */
#ifndef NXC_IMAGE_H
#define NXC_IMAGE_H
#include <stdint.h>

#define NXC_IMAGE_MAGIC 0x54534e58u /* "TSNX" */
#define NXC_IMAGE_VERSION 11u
#define NXC_UNITS_PER_CLOCK 1000
#define NXC_NO_LOOKAHEAD (INT64_MAX / 2)
/* The largest data cache and translation buffer that can be simulated: cache.h. */
enum { NXC_CACHE_SETS = 1024, NXC_TLB_SETS = 64, NXC_CACHE_WAYS = 4, NXC_CACHE_SET_BYTES = 32 };

/* --- profile: the tables of a compiled file, which nobody writes to --- */

/* A function of the source, where it is not inlined or inlined into another; or a line in such a function,
 * where only calls of one library function count if there is one. Texts lie so many bytes behind the first
 * cell of the file; 0: none. */
struct nxc_cell {
    int32_t parent;   /* of a line: its function; of a function: that into which it is inlined, -1: none */
    int32_t file;     /* of the source */
    int32_t function; /* 0: it is a line */
    int32_t called;   /* the library function */
    int32_t line;     /* of the function's beginning, or the line itself */
};

/* What one of a count costs for a cell. */
struct nxc_weight {
    int64_t units;
    int32_t slot, cell;
};

/* A compiled function. */
struct nxc_body {
    int32_t cells;   /* the first struct nxc_cell of the file is so many bytes from here */
    int32_t weights; /* and the function's first struct nxc_weight */
    int32_t cell;    /* of the function */
    int32_t slots, weight_count, unused;
};

/* A path of calls: a function, called by the function of the path's parent. */
struct nxc_path {
    const struct nxc_body *body;      /* NULL: no compiled function */
    struct nxc_path *recent;          /* the child that was entered last, or any path without a body */
    struct nxc_path *parent;          /* NULL: nobody has called it */
    struct nxc_path *children, *next; /* the first child; the parent's next one */
    struct nxc_path *older;           /* of all paths of the node */
    int64_t depth;
    int64_t counts[]; /* body->slots of them */
};

struct nxc_image {
    uint32_t magic;
    uint32_t version;
    int64_t *left;                      /* the counter */
    int64_t *lookahead;                 /* the lookahead's end, as a value of *left */
    int64_t *data_cache;                /* the size of the processor's, in bytes, which the simulator sets */
    int (*main)(int, char **, char **); /* the program */
    void (**init_begin)(void);          /* constructors, run on the node before main */
    void (**init_end)(void);
    void (**fini_begin)(void); /* destructors, run at its end after atexit functions, last first */
    void (**fini_end)(void);
    const struct nxc_body *bodies_begin; /* both NULL: built without --profile */
    const struct nxc_body *bodies_end;
    struct nxc_path *root;         /* has called main; the node's first path */
    struct nxc_path **path;        /* where the program is */
    int64_t long_bytes;            /* the size of long in C: 8, or 4 (nxcc --long32) */
    const struct nxc_races *races; /* races.h; NULL: built without --races and --asan */
};

/* Served by the simulator: lets virtual time catch up with the program, and returns with *left set anew.
 * Programs for simulated nodes call it by NXC_CALL_ENTER of nxcc/runtime/enter.h, never as a function. */
void nxc_preempt(void);
/* Served by the simulator: a zeroed path with so many counts. */
struct nxc_path *nxc_new_path(int64_t counts);
#endif
