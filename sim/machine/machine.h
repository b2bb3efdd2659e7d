/* machine.h - a machine put together from its parts, with a program on its nodes. */
#ifndef MACHINE_MACHINE_H
#define MACHINE_MACHINE_H
#include "node/system.h"

struct machine_options {
    const struct cfg_machine *cfg;
    uint32_t nodes;      /* 0, with host: all that the machine has, and the host program gets some of them */
    bool host;           /* the program is one for the host, which gets nodes and loads others on them */
    const char *program; /* with host: what it may find by name, whatever the folder; NULL: nothing */
    int argc;            /* of the program; argv[0] is its path */
    char **argv, **envp;
    double max_virtual_s; /* 0: none */
    double max_wall_s;    /* 0: none */
    double slice_s;       /* longest slice of computing, 0: a tenth; see sim/node/cpu.h */
    unsigned workers;     /* threads in all; 0 or 1: one. Results do not depend on it */
    uint64_t shuffle;     /* not 0: the threads go about it at random, to test that */
    bool isolate;         /* a node that writes to another's memory crashes; one thread */
    FILE *out, *err;      /* the programs' output */
    FILE *history;        /* gets a line for each message received; NULL: not wanted */
    const char *cfs_dir;  /* the folder that holds the files of /cfs; NULL: a temporary one */
};

enum machine_outcome { MACHINE_ENDED, MACHINE_FAILED, MACHINE_DEADLOCK };

struct machine {
    struct machine_options options;
    struct node_system sys;
    struct node_image *image;
    enum machine_outcome outcome;
    char *message;                /* what went wrong, for the user, one or more lines; NULL: nothing */
    struct workers_stats workers; /* how the threads did; all 0: there was one */
    int signal;                   /* that ended the run; 0: none */
    vtime end;                    /* when the last program ended */
    double begin;                 /* of the run, by the wall's clock */
    double wall_s, start_s;       /* the run; of which putting the machine together */
};

/* Puts it together, all programs loaded. NULL with *error set (malloc'd). */
struct machine *machine_new(const struct machine_options *options, char **error);
/* Runs it until all programs have ended or something stops it; sets outcome and message. */
void machine_run(struct machine *m);
/* Nodes that there are in a report: all, or those that a host program has ever had. */
uint32_t machine_nodes(const struct machine *m);
void machine_free(struct machine *m);
#endif
