/* compare_gate.h - touchstone check: runs studies, compares them with a baseline and prints what differs, or
 * makes them the baseline.
 *
 * A study's name in the baseline is its file's name without folder and .cfg. The baseline's other studies are
 * not compared, and an update keeps them.
 */
#ifndef LAB_CHECK_COMPARE_GATE_H
#define LAB_CHECK_COMPARE_GATE_H
#include "lab/check/compare.h"
#include "lab/study/study.h"

struct gate_options {
    const char *baseline;     /* the file */
    const char *const *files; /* of studies; ended by NULL */
    struct compare_rules rules;
    const char *junit, *json;   /* files to write, or NULL */
    bool github;                /* write annotations of GitHub Actions, too (compare_export.h) */
    const char *dir;            /* the results of each study go to DIR/STUDY */
    bool update;                /* write the baseline */
    struct study_options study; /* for each study; gate_run() sets file and dir */
};

enum gate_end {
    GATE_PASSED,
    GATE_WORSE, /* a point is worse, missing or failed, as study.out tells */
    GATE_ERROR, /* *error is a malloc'd text for the user; the baseline is unchanged */
};
enum gate_end gate_run(const struct gate_options *options, char **error);
#endif
