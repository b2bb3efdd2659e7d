/* study_parts.h - what the files of a study share: study.c opens a study, study_estimate.c estimates how long
 * its points take, study_run.c runs them, study_points.c reads their results, study_report.c writes the
 * results down. */
#ifndef LAB_STUDY_STUDY_PARTS_H
#define LAB_STUDY_STUDY_PARTS_H
#include "files/scratch.h"
#include "lab/chart/speedup.h"
#include "lab/jobs/point_locks.h"
#include "lab/study/inputs.h"
#include "lab/jobs/journal.h"
#include "lab/study/study.h"

/* A point that the study does not leave out. */
struct work {
    struct digest key;
    uint64_t number; /* points.h */
    double cost;     /* in any unit */
};

struct study {
    struct study_options options;
    struct spec *spec;
    char *program, *dir; /* as absolute paths: the program, and the folder of the study file */
    struct inputs *inputs;
    struct work *work; /* count of spec->product slots; sorted by number or by cost */
    size_t count;
    struct scratch scratch; /* for the runs' temporary files */
    struct point_locks *locks;
    struct journal *journal;
    struct speedup *speedup; /* the baseline, once study_find_baseline() has found one; NULL without nodes */
    struct study_counts counts;
};

/* Sets costs to estimated seconds if the journal has points that ran with other inputs, such as another build
 * of the program. */
void study_estimate(struct study *s);
/* Sorts s->work by number, or by descending cost. */
void study_sort(struct study *s, bool by_cost);
#endif
