/* tie_sensitivity.h - how far a row's time depends on nothing: its range under small changes of a message's latency. */
#ifndef LAB_TABLES_TIE_SENSITIVITY_H
#define LAB_TABLES_TIE_SENSITIVITY_H
#include "lab/tables/results.h"
#include "lab/tables/tables.h"

enum { TIE_RUNS = 8 };

/* Runs each run whose row is marked (paper.cfg: tie_rows) TIE_RUNS times more, with the latency of a
 * message (hops and the steps of the protocol) changed by -2 % to +2 %, evenly spaced, and sets its range, its own time included. False with *error set when it could not. */
bool tie_sensitivity_run(const struct tables_options *o, struct results *r, char **error);
#endif
