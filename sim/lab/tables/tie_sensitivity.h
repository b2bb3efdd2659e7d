/* tie_sensitivity.h - the range of a row's time over orders of simultaneous events: the range of its
 * time under small changes of a message's latency, which change that order. */
#ifndef LAB_TABLES_TIE_SENSITIVITY_H
#define LAB_TABLES_TIE_SENSITIVITY_H
#include "lab/tables/results.h"
#include "lab/tables/tables.h"

enum { TIE_RUNS = 8 };

/* Repeats each marked run (paper.cfg: tie_rows) TIE_RUNS times with a message's latency (hops and protocol
 * steps) changed by -2 % to +2 %, evenly spaced, and sets the range of its time, its own time included. False
 * with *error malloc'd. */
bool tie_sensitivity_run(const struct tables_options *o, struct results *r, char **error);
#endif
