/* program.h - random programs: the operations of each node, and the machine. The seed determines the
 * program. */
#ifndef PROVE_PROGRAM_H
#define PROVE_PROGRAM_H
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

enum { MOST_NODES = 64, HOST = MOST_NODES, SCRIPTS, MOST_SET = 16, VALUES = 4 };

struct op {
    int number; /* in ops.def */
    long value[VALUES];
    double key; /* where it stands among the others, while they are chosen */
};

struct script {
    struct op *ops;
    size_t count, room;
};

struct program {
    uint64_t seed;
    const char *machine;
    uint32_t nodes;
    bool flushes, host, cube; /* host: there is a host program; cube: it calls getcube itself */
    bool profile, fortran;    /* fortran: with parts.f90 */
    bool mpi;                 /* with parts_mpi.h */
    bool little_memory;       /* too little for Fortran's library */
    bool traced, recorded;
    double most_virtual_s;
    char set[MOST_SET][48]; /* KEY=VALUE of the machine file */
    int set_count;
    char timing[160];              /* of --timing; "": the machine's usual */
    struct script script[SCRIPTS]; /* of each node, and the host's */
};

/* Random numbers (splitmix64), for what is chosen by a seed. */
uint64_t random_next(uint64_t *state);
uint64_t random_below(uint64_t *state, uint64_t n);
bool random_chance(uint64_t *state, double p);

struct program *program_new(uint64_t seed);
struct program *program_copy(const struct program *p);
void program_free(struct program *p);
size_t program_ops(const struct program *p);
/* A node's script as the environment gives it to player.c, "NAME=..."; malloc'd. */
char *program_script(const struct program *p, int node);
/* Smaller values that an operation's i-th may be tried with; how many. */
int program_smaller(const struct op *o, int i, long smaller[2]);
/* The program as C source, after the text of parts.h. */
void program_print(const struct program *p, const char *parts, FILE *f);
#endif
