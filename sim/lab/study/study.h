/* study.h - a study: runs a program at all points of a study file (spec.h), writes down and draws the
 * results.
 *
 *     study_open()     reads the file, checks every point, opens DIR and its journal
 *     study_run()      takes points that the journal lacks from the result cache, or runs them as child
 *                      processes "RUNNER run ..."
 *     study_each()     visits the results, a point at a time
 *     study_report()   writes DIR/results.json, results.csv, findings.md, and the pictures FILE.png and .svg
 *
 * A point's identity is the digest of its inputs (inputs.h). A result is in DIR/journal (journal.h) before
 * the next point starts: after any interruption the same command resumes and runs no point twice. The
 * processes of a session (session.h) share out the points by locks (point_locks.h). Memory does not grow with
 * the number of points, except for tables that the system can page out (scratch_memory.h).
 */
#ifndef LAB_STUDY_STUDY_H
#define LAB_STUDY_STUDY_H
#include <jansson.h>
#include <stdio.h>

#include "lab/study/spec.h"

struct study_options {
    const char *file;
    const char *runner;     /* the touchstone that runs a point */
    const char *program;    /* an absolute path, in place of the study's program; NULL: the study's */
    const char *programs;   /* the folder of programs that are not beside the study file */
    const char *machines;   /* the folder of machine files */
    const char *dir;        /* the folder for journal and results; made if missing */
    const char *cache;      /* the folder of the result cache (result_cache.h); NULL: none */
    const char *session;    /* the session's name (session.h); "": a single process */
    const char *const *set; /* more settings KEY=VALUE of every point's machine, ended by NULL; or NULL */
    const char *const *arguments; /* more arguments of every point's program, ended by NULL; or NULL */
    unsigned at_once;             /* child processes at a time */
    bool retry_failed;            /* run points again that failed in an earlier session */
    FILE *out;                    /* for what was done */
    FILE *progress;               /* for progress and warnings */
};

enum study_end {
    STUDY_DONE,
    STUDY_INCOMPLETE, /* a point or a picture failed, as progress tells; the rest is complete */
    STUDY_ERROR,      /* *error is a malloc'd text for the user */
    STUDY_STOPPED,    /* a signal stopped it; finished points are in the journal */
};

struct study *study_open(const struct study_options *options, char **error); /* NULL with *error */
void study_close(struct study *s);

/* Runs the points that have no result. Returns STUDY_DONE even if points failed. */
enum study_end study_run(struct study *s, char **error);

/* What study_run() did: points it ran, found in the journal, found in the cache; and how many of all points
 * failed. */
struct study_counts {
    size_t run, before, cached, failed;
    int signal; /* the signal that stopped it; 0: none */
};
struct study_counts study_counts(const struct study *s);

/* The path of the program that the study runs. Borrowed. */
const char *study_program(const struct study *s);

/* { title, about, program, axes: { NAME: [value ...] } }, owned by the caller. */
json_t *study_header(const struct study *s);
/* Calls visit with each point in order, as a flat object that is valid during the call:
 *
 *     AXIS: value ...            the point's value on each axis
 *     failure                    null, or why the run failed
 *     wall_time_s                host time of the run
 *     KEY: figure ...            the run's figures (point_figures.h)
 *     time_s                     total_s if the program prints that figure, otherwise virtual_time_s
 *     speedup, speed_per_node    against the study's baseline (lab/chart/speedup.h), if it has an axis nodes
 *     profile                    as touchstone run --profile writes it, if the study asks for one
 *
 * False with *error if visit fails, or a point has not been run. */
typedef bool study_visit(void *arg, const json_t *point, char **error);
bool study_each(struct study *s, study_visit *visit, void *arg, char **error);

/* Writes results, findings and pictures. */
enum study_end study_report(struct study *s, char **error);
#endif
