/* study_points.h - the results of a study's points, beside what study.h has. */
#ifndef LAB_STUDY_STUDY_POINTS_H
#define LAB_STUDY_STUDY_POINTS_H
#include "lab/study/study_parts.h"

/* Finds the baseline of speed-ups among the results of all points; s->speedup stays NULL in a study without
 * an axis nodes. False with *error malloc'd if a point has not been run. */
bool study_find_baseline(struct study *s, char **error);
#endif
