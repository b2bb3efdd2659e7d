/* system.h - what all nodes of one machine share. sim/machine makes it, and alone assigns what names no other
 * owner (node.h), except for `running` and `guards`. */
#ifndef NODE_SYSTEM_H
#define NODE_SYSTEM_H
#include <stdio.h>
#include "config/config.h"
#include "kernel/arena.h"
#include "lp/schedule.h"
#include "node/self.h"
#include "timing/timing.h"

struct fence;
struct fence_refusal; /* guest/libc/fence.h */
struct recorder;
struct numbering; /* replay/numbering.h */
struct order_policy;
struct asan;
struct races;
struct mpi_checks;

enum { NODE_HOST_FILES = 64, NODE_TYPE_HASHES = 1024 };

struct node_absent {
    char *function, *first; /* the node that called it first */
    uint64_t calls;
};

struct node_system {
    const struct cfg_machine *cfg;
    struct schedule schedule;
    struct topo topo;
    struct fence *fence;      /* files of this computer that programs may use: fence.h. NULL: all */
    const struct node_fs *fs; /* the machine's file system, NULL none: file.h */
    struct cfs *cfs;          /* the same, for NX's own calls on it: cfs/cfs.h */
    struct node **nodes;
    struct arena made, made_cold;  /* what nodes are made of; to be freed behind them */
    struct node_region *roomy;     /* guest: regions of address space with room for more nodes: span.h */
    uintptr_t regions_end;         /* guest: of the latest that lies where all are meant to; 0: none */
    _Atomic uint64_t streams_made; /* guest: of so many nodes, on any thread */
    struct span_texts *texts;      /* guest: guest/span_texts.h. NULL: none yet */
    bool isolate;                  /* only `writable` may write to its memory: isolate.h */
    struct node *writable;         /* os. NULL: none */
    enum node_guards guards;       /* the least that any region has */
    size_t most_mappings; /* not 0: as if the host allowed so many, and had no lighter guards; for tests */
    struct node *host;    /* the node that runs the host program, NULL: none. Its number is count. */
    struct cube *cube;    /* what a host program does with the nodes, NULL: all have been loaded: cube.h */
    uint32_t count;       /* nodes; with a host program: of its cube, 0 when it has none */
    uint32_t running;     /* programs */
    bool flushes;         /* one of them may throw away messages of others */
    bool main_tells;      /* what main returns is as if it called exit with that: of MPI programs */
    uint32_t await_ends;  /* os: of them are in calls that wait for another's end */

    size_t most_unreceived; /* bytes of messages that may wait in a node: os/flood.h */

    /* os: the first failure, for the user; NULL none */
    char *failure;

    /* output: a FILE for each of fd 1 and 2, written in the order of virtual time */
    FILE *out[2];
    struct progress_line *progress; /* on the terminal that has the output; NULL: none */

    uint64_t digest;          /* of all messages received: time, nodes, type, length, in order */
    FILE *history;            /* the same as text, a line for each; NULL: not wanted */
    uint64_t messages, bytes; /* received by nodes */
    /* a set of hashes of the types received by nodes */
    uint64_t types_come[NODE_TYPE_HASHES / 64];
    struct timing *timing;             /* NULL: the machine's usual */
    struct numbering *numbering;       /* NULL: the run is neither recorded as a schedule nor keeps orders */
    const struct order_policy *orders; /* os/order_policy.h. NULL: the run keeps none */
    struct recorder *recorder;         /* of the run's trace: record/node_record.h. NULL: none */
    struct asan *asan;                 /* of the programs built with --asan: asan/asan_check.h */
    struct mpi_checks *mpi_checks;     /* mpi_api/checks/mpi_checks.h. NULL: nothing is checked */
    struct races *races; /* of the programs built with --races: races/race_check.h. NULL: there are none */
    /* guest: names of host files that programs have used, each once; ended by NULL, or NULL */
    char **host_files;
    /* guest: functions that nodes do not have, and programs called; by first call */
    struct node_absent *absent;
    size_t absent_count;    /* guest */
    size_t host_file_count; /* guest: at most NODE_HOST_FILES: of more, the first */

    /* Is told of programs, each of which has a thread: guest/debugger.h. NULL: none. */
    struct debugger *debugger;
    struct debug_stop *stop; /* where it is to stop: machine/debug_stop.h. NULL: nowhere */

    bool exit_told; /* the user knows of the first exit with an error */
    bool mid_line;  /* what programs last wrote on standard error does not end its line */

    /* Set by the machine; NULL before it runs. */
    void (*keep_crash)(
        struct node *n); /* the crash has been set, on the calling thread, and would not last */
    /* At a limit of virtual time: true if that does not end the run. */
    bool (*pauses)(struct node_system *s);
    void (*crashed)(struct node *n); /* at its moment: reports its crash */
    void (*exited)(struct node *n);  /* at its moment: by exit with an error */
    /* Ends the run: the program of n, which runs, used a file that the fence refuses. */
    void (*refused)(struct node *n, const struct fence_refusal *r);
    /* Where the calls under way on the node's stack return to, from a frame upwards, at most so many; how
     * many there are. */
    int (*calls_from)(const struct node *n, uintptr_t frame, uintptr_t *returns, int most);
    /* the calls under way on the node's stack, from a frame upwards, a line for each */
    void (*print_calls)(FILE *f, const struct node *n, uintptr_t frame);
};

static inline uint32_t node_type_hash(int64_t type)
{
    return (uint32_t)((uint64_t)type * UINT64_C(0x9e3779b97f4a7c15) >> 54); /* of 10 bits */
}

/* Who lives at an address of the network, and the number by which programs know them. */
static inline struct node *node_at(const struct node_system *sys, uint32_t address)
{
    return sys->host && address == sys->host->lp.address ? sys->host : sys->nodes[address];
}
static inline uint32_t node_number(const struct node_system *sys, uint32_t address)
{
    return sys->host && address == sys->host->lp.address ? sys->count : address;
}

/* The node in whose memory an address lies; NULL: it is in no node's. Asks all: for reports. */
static inline const struct node *node_owner(const struct node_system *sys, uintptr_t address)
{
    for (uint32_t i = 0; i < sys->count; i++)
        if (node_owns(sys->nodes[i], address))
            return sys->nodes[i];
    return NULL;
}

/* Its number in the run's timing. */
static inline uint32_t node_timed(const struct node *n)
{
    return n->is_host ? TIMING_HOST : n->lp.address;
}

/* The machine whose schedule this is. */
static inline struct node_system *system_of(struct schedule *s)
{
    return (struct node_system *)((char *)s - offsetof(struct node_system, schedule));
}
#endif
