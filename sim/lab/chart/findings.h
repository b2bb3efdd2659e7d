/* findings.h - a study's page of findings, in Markdown, made from its results alone. */
#ifndef LAB_CHART_FINDINGS_H
#define LAB_CHART_FINDINGS_H
#include "lab/chart/picture.h"
#include "lab/chart/record.h"

/* Writes DIR/findings.md: what was run, and for each picture a link to the picture in DIR, its figures as a
 * table, and sentences that follow from the figures. False with *error malloc'd. */
bool findings_write(const struct record_points *points, const struct picture *list, size_t count,
                    const char *dir, char **error);
#endif
