/* chart_scale.h - an axis of a picture: its range, linear or logarithmic, and its tics. */
#ifndef LAB_CHART_CHART_SCALE_H
#define LAB_CHART_CHART_SCALE_H
#include "lab/chart/chart_data.h"

#include <stdio.h>

struct scale {
    bool log;
    double low, high;
};

/* The scale of an axis's values. numbers that are not all above 0, and names, are linear. */
struct scale scale_of_axis(const struct chart_axis *axis, bool log);
/* The scale of the values from low to high, with room around them. A logarithmic scale needs values above 0
 * and a factor of 2 between them; a linear scale begins at 0 if a value is below half the greatest. */
struct scale scale_of_values(double low, double high, bool log);
bool scale_may_be_log(double low, double high);

/* Where the value is on the axis, from 0 at low to 1 at high; and back. */
double scale_part(const struct scale *s, double value);
double scale_value(const struct scale *s, double part);

/* Write gnuplot's range and tics for axis `which`, x or y: at the axis's values, if they are not too many,
 * with labels where these have room on so many pixels; or at round numbers. */
void scale_write_axis(const struct scale *s, char which, const struct chart_axis *axis, unsigned pixels,
                      FILE *out);
void scale_write(const struct scale *s, char which, FILE *out);
/* How many pixels the widest label at round numbers takes, about. */
unsigned scale_widest_tic(const struct scale *s);

/* Writes text in gnuplot's single quotes. */
void scale_write_quoted(const char *text, FILE *out);
/* How many pixels the text is wide, about. */
unsigned scale_text_width(const char *text);
#endif
