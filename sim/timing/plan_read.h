/* plan_read.h - reads schedules (doc/schedule-format.md). */
#ifndef TIMING_PLAN_READ_H
#define TIMING_PLAN_READ_H
#include "timing/plan.h"

/* Reads a file. NULL with *error, malloc'd, that says "FILE:LINE: what is wrong". */
struct plan *plan_read(const char *path, char **error);
#endif
