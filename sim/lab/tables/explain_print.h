/* explain_print.h - shows where the time of a row went (explain.h). */
#ifndef LAB_TABLES_EXPLAIN_PRINT_H
#define LAB_TABLES_EXPLAIN_PRINT_H
#include "lab/tables/explain.h"

#include <stdio.h>

/* Print an explanation: as text with all layers, and as a short table in Markdown. */
void explain_print(const struct explain *e, FILE *out);
void explain_markdown(const struct explain *e, FILE *out);
#endif
