/* chart.h - a study's pictures, as gnuplot scripts. */
#ifndef STUDY_CHART_H
#define STUDY_CHART_H
#include "study/points.h"

#include <stdio.h>

/* Writes a script that draws picture into DIR/FILE.png and .svg. Points that failed or lack the figure are left out;
 * false if that leaves nothing. */
bool chart_write(const struct points *p, const struct spec_picture *picture, const char *dir, FILE *script);
#endif
