/* choices.h - a page in Markdown: the tables' errors with each choice of fitted.cfg changed. */
#ifndef LAB_TABLES_CHOICES_H
#define LAB_TABLES_CHOICES_H
#include "lab/tables/results.h"
#include "lab/tables/tables.h"

/* Runs all rows of r again with each alternative that fitted.cfg names, and writes the mean and worst errors
 * to path, as an atomic file. r has been run. False with *error malloc'd. */
bool choices_write(const struct tables_options *o, const struct results *r, const char *path, char **error);
#endif
