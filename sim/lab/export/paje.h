/* paje.h - a trace in Paje's format. */
#ifndef LAB_EXPORT_PAJE_H
#define LAB_EXPORT_PAJE_H
#include <stdbool.h>
#include <stdio.h>
#include "lab/export/export_progress.h"
#include "lab/export/timeline.h"

/* False with *error (malloc'd) if a temporary file failed. Whether `out` did, it says itself. */
bool paje_write(const struct timeline *l, FILE *out, const struct export_progress *p, char **error);
#endif
