/* export_progress.h - shows a terminal how much of a trace is written, if that takes more than a second. */
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
/* So many of a table's rows are written: shown from time to time. */
void export_progress_rows(const struct export_progress *p, size_t rows, size_t of);
/* Erases the terminal's line. */
void export_progress_end(const struct export_progress *p);
#endif
