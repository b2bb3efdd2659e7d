/* record.h - a study's results as JSON and as comma-separated values. Only figures whose name holds "wall_time" differ
 * between two runs of one study. */
#ifndef STUDY_RECORD_H
#define STUDY_RECORD_H
#include "study/points.h"

#include <stdio.h>

/* { title, program, machine, axes: { NAME: [value ...] }, points: [{ AXIS: value ..., failure, KEY: figure ... }] } */
json_t *record_json(const struct points *p);
/* A line of names, and one for each point; figures that are lists are left out. */
void record_csv(const struct points *p, FILE *out);
#endif
