/* program_options.h - the options of the commands that run one program: which program, on which machine, and
 * for how long at most. Their defaults stand here, for all of these commands. */
#ifndef CLI_PROGRAM_OPTIONS_H
#define CLI_PROGRAM_OPTIONS_H
#include "cli/options.h"
#include "files/program_file.h"

/* The texts are argv's. */
struct cli_program {
    const char *machine, *host; /* host: NULL if there is none */
    uint32_t nodes;             /* of the first program. 0: as many as the host program asks for */
    const char **set;           /* KEY=VALUE, ended by NULL; the caller frees the list */
    size_t set_count;
    double max_virtual_s, max_wall_s; /* 0: not said */
    uint32_t max_unreceived_mb;       /* 0: not said */
    char **program;                   /* with its arguments; without a host, there is one */
    int program_count;
    /* The programs among these words: the one, and others, as `-n 1 PROGRAM : -n 4 OTHER` names them. */
    struct named_program *programs;
    size_t programs_count;
    char **found; /* paths of programs that are not where they were named */
    size_t found_count;
};

/* -m, -n, --set, --host, --max-virtual-time, --max-wall-time, --max-unreceived, and the program with its
 * arguments; input: struct cli_program *. Groups of its help: 1 machine, 3 limits. */
extern const struct argp CLI_PROGRAM;
/* How such a command is called: struct argp's args_doc. */
extern const char CLI_PROGRAM_ARGUMENTS[];

/* Replaces the names of programs that are not here by the paths of those that come with touchstone, in the
 * folder `brought`. False with *error, malloc'd, if there is no such program. verbose: says so on standard
 * error. */
bool cli_program_find(struct cli_program *p, const char *brought, bool verbose, char **error);
/* All nodes that the options name, of all programs. */
uint32_t cli_program_nodes(const struct cli_program *p);
void cli_program_free(struct cli_program *p);

/* Adds the value of --set to a list that has room for it. */
void cli_add_setting(struct argp_state *state, const char **set, size_t *count, const char *setting);

#endif
