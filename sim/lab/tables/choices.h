/* choices.h - what each choice that was made with the paper's tables in view does to them, as a page in Markdown. */
#ifndef LAB_TABLES_CHOICES_H
#define LAB_TABLES_CHOICES_H
#include "lab/tables/results.h"
#include "lab/tables/tables.h"

/* Runs all rows of r once more for each alternative that fitted.cfg names, in place of what was chosen, and writes the mean
 * and worst errors to path, whole or not at all. r has been run. False with *error set. */
bool choices_write(const struct tables_options *o, const struct results *r, const char *path, char **error);
#endif
