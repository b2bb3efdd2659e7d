/* csv_table.h - a table of a trace as comma-separated values. */
#ifndef LAB_EXPORT_CSV_TABLE_H
#define LAB_EXPORT_CSV_TABLE_H
#include <stdio.h>
#include "lab/export/export.h"
#include "lab/export/export_progress.h"

/* table: not EXPORT_TABLES. Whether `out` failed, it says itself. */
void csv_table_write(const struct trace *t, enum export_table table, FILE *out,
                     const struct export_progress *p);
#endif
