/* baseline_point.h - the form in which a baseline (baseline.h) has a point: its figures, and where its nodes'
 * time went. */
#ifndef LAB_CHECK_BASELINE_POINT_H
#define LAB_CHECK_BASELINE_POINT_H
#include <jansson.h>

/* The baseline's form of a study's point (study_each() in study.h). axes is an object whose keys are the
 * names of the study's axes. Host times and paths are left out. */
json_t *baseline_point(const json_t *point, const json_t *axes);
/* The point's name, malloc'd: "nodes 8, group 4". */
char *baseline_name(const json_t *point, const json_t *axes);
#endif
