/* findings.h - a study's page of findings: Markdown, made from its results alone. */
#ifndef LAB_CHART_FINDINGS_H
#define LAB_CHART_FINDINGS_H
#include "lab/chart/picture.h"
#include "lab/chart/record.h"

/* Writes DIR/findings.md: what was run, and for each picture the picture, its figures as a table, and what can be read
 * off them. Pictures are linked by their file names, as they lie beside the page. False with *error malloc'd. */
bool findings_write(const struct record_points *points, const struct picture *list, size_t count,
                    const char *dir, char **error);
#endif
