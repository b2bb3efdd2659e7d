/* why_report.h - the analysis of why a run took its time, as text for people. */
#ifndef LAB_WHY_REPORT_H
#define LAB_WHY_REPORT_H
#include "lab/jobs/rerun.h"
#include "lab/why/why.h"

struct why_report_options {
    size_t top;                  /* rows of each table; 0: all */
    const struct reruns *reruns; /* NULL: none */
    struct why *than;            /* another run to compare with; NULL: none */
};

/* Sentences, then tables. */
void why_report(struct why *w, const struct why_report_options *o, FILE *f);
#endif
