/* fit_position.c - a parameter's value and its position in the range, from 0 to 1; see fit_parts.h. */
#include "lab/fit/fit_parts.h"

#include <math.h>
#include <stdio.h>

double fit_value(const struct fit_parameter *p, double position)
{
    return p->logarithmic ? p->from * pow(p->to / p->from, position) : p->from + position * (p->to - p->from);
}

double fit_position(const struct fit_parameter *p, double value)
{
    return p->logarithmic ? log(value / p->from) / log(p->to / p->from)
                          : (value - p->from) / (p->to - p->from);
}

void fit_text(const struct fit_parameter *p, double position, char text[32])
{
    snprintf(text, 32, "%.6g", fit_value(p, position));
}
