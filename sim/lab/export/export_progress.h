/* export_progress.h - shows a terminal how many nodes of a trace are written, if that takes more than a
 * second. */
#ifndef LAB_EXPORT_EXPORT_PROGRESS_H
#define LAB_EXPORT_EXPORT_PROGRESS_H
#include <stdint.h>
#include <stdio.h>

struct export_progress {
    FILE *to; /* NULL: nowhere */
    int32_t nodes;
    double began; /* host time, in seconds */
};

struct export_progress export_progress_begin(FILE *to, int32_t nodes);
/* Nodes up to this one are written. */
void export_progress_show(const struct export_progress *p, int32_t node);
/* Erases the terminal's line. */
void export_progress_end(const struct export_progress *p);
#endif
