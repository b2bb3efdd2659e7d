/* points.h - the points of a study, each with its command line and what came of it. */
#ifndef STUDY_POINTS_H
#define STUDY_POINTS_H
#include "study/spec.h"

#include <jansson.h>

struct point {
    size_t at[SPEC_MAX_AXES]; /* for each axis the place of its value */
    char *name;               /* for people: "nodes 16, group 2" */
    char **argv;              /* its run, ended by NULL */
    json_t *figures;          /* object, flat: what it came to (figures.h); NULL before, and when it failed */
    char *failure;
    double wall_time_s;
};

struct points {
    const struct spec *spec;
    struct point *point;
    size_t count;
};

/* Where the parts of a command line are. */
struct points_places {
    const char *runner;  /* the touchstone that runs a point */
    const char *program; /* the study's program, as a path */
    const char *scratch; /* a folder for what the runs leave; point i writes its figures to I.json in it */
};

/* All values of all axes with all others, the last axis changing fastest, less those left out. s must outlive it. */
struct points points_plan(const struct spec *s, const struct points_places *places);
void points_free(struct points *p);

double points_figure(const struct point *p, const char *key); /* NAN if it has none of that name */
#endif
