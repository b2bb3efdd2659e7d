/* study.h - a study: a program run at all points of a study file (spec.h), what came of it written down and drawn.
 *
 * Each point is a child process "RUNNER run ... PROGRAM ARGS", with a Concurrent File System of its own that is gone
 * after it. What comes out: DIR/results.json and DIR/results.csv, and DIR/FILE.png and .svg for each picture.
 */
#ifndef STUDY_STUDY_H
#define STUDY_STUDY_H
#include <stdio.h>

struct study_options {
    const char *file;
    const char *runner;   /* the touchstone that runs a point */
    const char *programs; /* where a program is that is not beside the file */
    const char *dir;      /* for the results; made if need be */
    unsigned at_once;     /* children at a time */
    FILE *out;            /* what was done */
    FILE *progress;       /* how it is getting on */
};

enum study_end {
    STUDY_DONE,
    STUDY_INCOMPLETE, /* a point or a picture failed: it was named, the rest is there */
    STUDY_ERROR,      /* nothing was written; *error is a malloc'd text for the user */
};
enum study_end study_make(const struct study_options *options, char **error);
#endif
