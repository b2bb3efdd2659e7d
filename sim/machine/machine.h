/* machine.h - a machine put together from its parts, with a program on its nodes. */
#ifndef MACHINE_MACHINE_H
#define MACHINE_MACHINE_H
#include <signal.h>
#include "files/program_file.h"
#include "guest/libc/progress_line.h"
#include "machine/debug_stop.h"
#include "node/system.h"
#include "nx_api/waitfor/waitfor.h"

struct machine_options {
    const struct cfg_machine *cfg;
    uint32_t nodes;      /* 0 with host: all that the machine has, of which the host program gets some */
    bool host;           /* the program runs on the host, gets nodes, and loads other programs on them */
    const char *program; /* with host: what the host program may load by name alone; NULL: nothing */
    const struct named_program *programs; /* in the order of their nodes; with host, one: the host's */
    size_t program_count;
    char **envp;
    double max_virtual_s;  /* 0: none */
    vtime until;           /* the run stops then, and reports where the nodes are; 0: at no time */
    double max_wall_s;     /* 0: none */
    size_t max_unreceived; /* bytes of messages that may wait in a node; 0: the usual, os/flood.h */
    double slice_s;        /* longest slice of computing; 0: no slices. For tests: changes no result */
    unsigned workers;      /* threads in all; 0 or 1: one. Changes no result */
    uint64_t shuffle;      /* not 0: seeds random choices of the threads, for tests. Changes no result */
    bool progress;         /* err is a terminal, which is to show how far the run has come */
    /* A debugger is attached: it is told of the programs, each of which has a thread; one of them runs at a
     * time, and there is no limit of real time. Changes no result. */
    bool debugged;
    struct debug_stop_options stop; /* in the debugger */
    /* Another timing than the machine's usual: one of the two, or both NULL. */
    const struct draw *draw;
    const struct plan *plan;
    FILE *schedule;      /* gets the run's schedule; NULL: none */
    bool isolate;        /* a node that writes to another's memory crashes; the run uses one thread */
    bool mpi_checks;     /* calls of MPI are checked: mpi_api/checks/mpi_checks.h */
    FILE *out, *err;     /* the programs' output */
    FILE *history;       /* gets a line for each message received; NULL: no history */
    struct fence *fence; /* files of this computer that programs may use: guest/libc/fence.h. NULL: all */
    char *const *layer;  /* functions that reports do not name: guest/layer.h; NULL: none */
    const char *cfs_dir; /* the folder that holds the files of /cfs; NULL: a temporary one */
};

enum machine_outcome { MACHINE_ENDED, MACHINE_FAILED, MACHINE_DEADLOCK, MACHINE_STOPPED };

struct machine {
    struct machine_options options;
    struct node_system sys;
    struct node_image **images; /* the program's, and those of other programs */
    size_t image_count;
    enum machine_outcome outcome;
    char *message; /* how the run ended, for the user, one or more lines; NULL: nothing to say. Malloc'd */
    bool said;     /* the message was printed when it was known, on sys.out[1] */
    /* Of a deadlock, or of what waits behind an exit with an error: who waits for whom. NULL: none */
    struct waitfor *waits;
    struct workers_stats workers; /* figures of the threads; all 0: there was one */
    struct debug_stop stop;
    struct backtrace_lines *lines; /* for the schedule; NULL: none */
    struct progress_line progress;
    double progress_at;      /* hostclock_s() at the next */
    double output_at;        /* when what programs have written is flushed */
    sigset_t signals_before; /* what was blocked before the run */
    _Atomic int signal;      /* the signal that ended the run; 0: none */
    vtime end;               /* when the last program ended */
    double begin;            /* hostclock_s() at the start of the run */
    double wall_s, start_s;  /* seconds of host time: of the run; of putting the machine together */
};

/* Makes a machine of its parts, with all programs loaded. Returns NULL and sets *error (malloc'd) on
 * failure. *options and what it refers to must last as long as the machine. */
struct machine *machine_new(const struct machine_options *options, char **error);
/* The machine's run is recorded: r must last until it has run. Call before machine_run(). */
void machine_record(struct machine *m, struct recorder *r);
/* Runs the machine until all programs have ended, or something stops it; sets outcome, message, end and the
 * figures. To be called once. */
void machine_run(struct machine *m);
/* A number that tells programs apart, from what is loaded of them. */
uint32_t machine_program_sum(const struct machine *m);
/* The number of nodes in a report: all, or those of the host program's largest cube. */
uint32_t machine_nodes(const struct machine *m);
void machine_free(struct machine *m);
#endif
