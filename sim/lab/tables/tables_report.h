/* tables_report.h - the tables as a report in Markdown: their errors, what was fitted, and where the time of
 * the rows with the largest errors goes. */
#ifndef LAB_TABLES_TABLES_REPORT_H
#define LAB_TABLES_TABLES_REPORT_H
#include "lab/tables/results.h"
#include "lab/tables/tables.h"

/* Writes the report to path, as an atomic file. Runs the rows with the largest errors again with -times. The
 * report does not depend on the computer or the day. False with *error malloc'd. */
bool tables_report_write(const struct tables_options *o, struct results *r, const char *path, char **error);
#endif
