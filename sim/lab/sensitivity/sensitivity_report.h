/* sensitivity_report.h - the answer of a sensitivity (sensitivity.h) that has run, as a table and as JSON. */
#ifndef LAB_SENSITIVITY_SENSITIVITY_REPORT_H
#define LAB_SENSITIVITY_SENSITIVITY_REPORT_H
#include <jansson.h>
#include <stdio.h>
#include "lab/sensitivity/sensitivity.h"

/* The ten largest. name: of the program. */
void sensitivity_print(const struct sensitivity *s, const char *name, const char *machine, FILE *f);
/* An array of all numbers. */
json_t *sensitivity_json(const struct sensitivity *s);
#endif
