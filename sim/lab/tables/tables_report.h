/* tables_report.h - the tables as a report in Markdown: how exact they are, what was fitted, what remains. */
#ifndef LAB_TABLES_TABLES_REPORT_H
#define LAB_TABLES_TABLES_REPORT_H
#include "lab/tables/results.h"
#include "lab/tables/tables.h"

/* Writes it to path, whole or not at all. Runs the rows with the largest errors once more, measured, to say where their
 * time goes. False with *error set. Nothing in it depends on the computer or the day. */
bool tables_report_write(const struct tables_options *o, struct results *r, const char *path, char **error);
#endif
