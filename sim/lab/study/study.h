/* study.h - a study: a program run at all points of a study file (spec.h), what came of it written down and drawn.
 *
 *     study_open()     reads the file, checks every point, opens DIR and its journal
 *     study_run()      runs what the journal does not have: from the cache, or as child processes "RUNNER run ..."
 *     study_each()     the results, a point at a time
 *     study_report()   DIR/results.json, DIR/results.csv, DIR/FILE.png and .svg for each picture
 *
 * A point's identity is the digest of its inputs (inputs.h). Each result is in DIR/journal (journal.h) before the next is
 * begun: whatever kills us, the same command goes on, and runs no point twice. Several processes that mpirun or srun
 * started share a folder's points by its locks (point_locks.h). Nothing in memory grows with the number of points but tables
 * of 32 bytes a point, which the system can page out (scratch_memory.h).
 */
#ifndef LAB_STUDY_STUDY_H
#define LAB_STUDY_STUDY_H
#include <jansson.h>
#include <stdio.h>

#include "lab/study/spec.h"

struct study_options {
    const char *file;
    const char *runner;   /* the touchstone that runs a point */
    const char *program;  /* instead of the study's, absolute; NULL: the study's */
    const char *programs; /* where a program is that is not beside the file */
    const char *machines; /* the folder of machine files */
    const char *dir;      /* for journal and results; made if need be */
    const char *cache;    /* the folder of results kept for all studies (result_cache.h); NULL: none */
    const char *session;  /* common to the processes that share the work (session.h); "": this one alone */
    const char *const
        *set; /* settings KEY=VALUE of every point's machine, after its own; ended by NULL; or NULL */
    const char *const *arguments; /* words after every point's own arguments, ended by NULL; or NULL */
    unsigned at_once;             /* children at a time */
    bool retry_failed;            /* run points again that failed in an earlier session */
    FILE *out;                    /* what was done */
    FILE *progress;               /* how it is getting on, and what is odd */
};

enum study_end {
    STUDY_DONE,
    STUDY_INCOMPLETE, /* a point or a picture failed: it was named, the rest is there */
    STUDY_ERROR,      /* *error is a malloc'd text for the user */
    STUDY_STOPPED,    /* by a signal; what was done is in the journal */
};

struct study *study_open(const struct study_options *options, char **error); /* NULL with *error */
void study_close(struct study *s);

/* STUDY_DONE also if points failed. */
enum study_end study_run(struct study *s, char **error);

/* What study_run() did: points it ran, found in the journal, found in the cache; and of all points the failed ones. */
struct study_counts {
    size_t run, before, cached, failed;
    int signal; /* that stopped it; 0: none */
};
struct study_counts study_counts(const struct study *s);

/* { title, about, program, axes: { NAME: [value ...] } } */
json_t *study_header(const struct study *s);
/* Calls visit with each point in order, as one flat object: AXIS: value ..., failure (null or a text), wall_time_s,
 * KEY: figure ... (point_figures.h), time_s (total_s if the program prints that, else virtual_time_s), speedup and speed_per_node against the point with the fewest nodes that is otherwise the
 * same, and profile (as touchstone run --profile writes it) where the study asks for one. The object is the visitor's for
 * the call. False with *error if a point has no result: it has not been run. */
typedef bool study_visit(void *arg, const json_t *point, char **error);
bool study_each(struct study *s, study_visit *visit, void *arg, char **error);

/* Writes results and pictures. */
enum study_end study_report(struct study *s, char **error);

/* All of it. */
enum study_end study_make(const struct study_options *options, int *signal, char **error);
#endif
