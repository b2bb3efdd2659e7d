/* study_parts.h - what the files of a study share: study.c opens it, study_estimate.c says how long
 * its points may take, study_run.c runs them, study_points.c reads
 * what they came to, study_report.c writes it down. */
#ifndef LAB_STUDY_STUDY_PARTS_H
#define LAB_STUDY_STUDY_PARTS_H
#include "files/scratch.h"
#include "lab/jobs/point_locks.h"
#include "lab/study/inputs.h"
#include "lab/jobs/journal.h"
#include "lab/study/study.h"

/* A point that is wanted. */
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
    struct work
        *work; /* spec->product places, of which count are used; in the order of numbers or of costs */
    size_t count;
    struct scratch scratch; /* a folder for what runs leave */
    struct point_locks *locks;
    struct journal *journal;
    struct study_counts counts;
};

/* Points that ran before with other inputs, such as another build of the program, should take as long as they did then:
 * where the journal knows of some, costs are seconds. */
void study_estimate(struct study *s);
/* By number, or the dearest first. */
void study_sort(struct study *s, bool by_cost);
#endif
