/* time_profile.h - the time of all nodes: computing by function, system time by task, idle
 * time by call.
 *
 *     nodes x virtual time = computing + system + idle + rest    for each class of nodes, to the picosecond
 *     computing            = the sum over the functions          to the cost unit
 *
 * Nodes with handlers are one class, all other nodes a second one, as in the summary: in many programs
 * the former are masters, the latter slaves. */
#ifndef OBSERVE_TIME_PROFILE_H
#define OBSERVE_TIME_PROFILE_H
#include "machine/machine.h"
#include "observe/call_tree.h"

enum profile_class { PROFILE_OTHERS, PROFILE_ARMED, PROFILE_CLASSES };

/* The time spent in a function of the source, without calls to the library; or in that function's calls
 * to one function of the library. The texts are in the machine's nodes. */
struct profile_function {
    const char *file, *function, *called; /* called: the library's function, or NULL */
    int64_t line;
    int64_t units[PROFILE_CLASSES];
};

struct profile_idle {
    const char *call;
    vtime_sum idle[PROFILE_CLASSES];
    uint64_t waits[PROFILE_CLASSES];
};

/* The sums over all nodes of a class. */
struct profile_times {
    uint32_t nodes;
    vtime_sum computing, system, idle;
    vtime_sum
        rest; /* from a node's end to the last one's; in a run that was stopped, also unfinished waits */
    vtime_sum tasks[NODE_TASKS], beside;
};

struct profile {
    struct profile_function *functions; /* most time first */
    size_t function_count;
    struct profile_idle *idle; /* longest first */
    size_t idle_count;
    struct profile_times times[PROFILE_CLASSES];
    vtime end; /* of the run */
    uint64_t units_per_second;
    struct call_tree tree;
};

/* Was the program built with nxcc --profile? */
bool profile_possible(const struct machine *m);
/* The profile of a machine that has run a program built with --profile. Free it by profile_free(). */
struct profile profile_collect(const struct machine *m);
void profile_free(struct profile *p);

/* Writes a table: the twelve functions with the most time, and the time outside of functions. */
void profile_print(const struct profile *p, FILE *f);
/* Writes the JSON file, whole or not at all. Returns NULL, or a malloc'd error. */
char *profile_json(const struct profile *p, const struct machine *m, const char *path);

/* Nodes of the class times the run's virtual time. */
vtime_sum profile_node_time(const struct profile *p, enum profile_class c);
double profile_seconds(const struct profile *p, int64_t units);
#endif
