/* time_profile.h - where the time of all nodes went: computing by function, the system by task, idle time by call.
 *
 *     nodes x virtual time = computing + system + idle + rest         for each class of nodes, to the picosecond
 *     computing            = the sum over the functions               to the cost unit
 *
 * Nodes that took interrupts are one class, the others another, as in the summary: hosts and slaves differ.
 */
#ifndef OBSERVE_TIME_PROFILE_H
#define OBSERVE_TIME_PROFILE_H
#include "machine/machine.h"

enum profile_class { PROFILE_OTHERS, PROFILE_ARMED, PROFILE_CLASSES };

/* What was spent in a function as it was written; or, apart from it, in the calls from there to one function of the
 * library. The texts lie in the machine's nodes. */
struct profile_function {
    const char *file, *function, *called; /* called: NULL none */
    int64_t line;
    int64_t units[PROFILE_CLASSES];
};

struct profile_idle {
    const char *call;
    vtime idle[PROFILE_CLASSES];
    uint64_t waits[PROFILE_CLASSES];
};

/* Times of all nodes of a class together. */
struct profile_times {
    uint32_t nodes;
    vtime computing, system, idle;
    int64_t
        rest; /* after a node's end, until the last one's; in a run that was stopped, waits not over too */
    vtime tasks[NODE_TASKS], beside;
};

struct profile {
    struct profile_function *functions; /* dearest first */
    size_t function_count;
    struct profile_idle *idle; /* longest first */
    size_t idle_count;
    struct profile_times times[PROFILE_CLASSES];
    vtime end; /* the machine's */
    uint64_t units_per_second;
};

/* Was the program built with nxcc --profile? */
bool profile_possible(const struct machine *m);
/* Adds up a machine that has run; for a program that was built with --profile. */
struct profile profile_collect(const struct machine *m);
void profile_free(struct profile *p);

/* Writes a table: the dozen dearest functions, and the rest of the time. */
void profile_print(const struct profile *p, FILE *f);
/* Writes the JSON file, whole or not at all. Returns NULL, or a malloc'd error. */
char *profile_json(const struct profile *p, const struct machine *m, const char *path);

/* The time of all nodes of a class, until the machine's end. */
vtime profile_node_time(const struct profile *p, enum profile_class c);
double profile_seconds(const struct profile *p, int64_t units);
#endif
