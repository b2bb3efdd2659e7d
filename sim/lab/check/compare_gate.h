/* compare_gate.h - touchstone check: runs studies, compares them with a baseline, says what differs; or makes them the
 * baseline.
 *
 * A study is known in the baseline by its file's name without folder and .cfg. Of the baseline's other studies nothing is
 * said, and they stay when it is written anew. Points are compared one at a time; of those that are the same only the
 * name is kept.
 */
#ifndef LAB_CHECK_COMPARE_GATE_H
#define LAB_CHECK_COMPARE_GATE_H
#include "lab/check/compare.h"
#include "lab/study/study.h"

struct gate_options {
    const char *baseline;     /* the file */
    const char *const *files; /* of studies; ended by NULL */
    struct compare_rules rules;
    const char *junit;          /* a file to write, or NULL */
    const char *dir;            /* what runs leave goes to DIR/STUDY */
    bool update;                /* write the baseline */
    struct study_options study; /* of each study; file and dir are set here */
};

enum gate_end {
    GATE_PASSED,
    GATE_WORSE, /* a point is worse, missing or failed: it was told on study.out */
    GATE_ERROR, /* *error is a malloc'd text for the user; the baseline is as it was */
};
enum gate_end gate_run(const struct gate_options *options, char **error);
#endif
