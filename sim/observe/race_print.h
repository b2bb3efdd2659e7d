/* race_print.h - the races of a run as text for people. */
#ifndef OBSERVE_RACE_PRINT_H
#define OBSERVE_RACE_PRINT_H
#include <stdio.h>
#include "observe/race_report.h"

/* Each race: the accesses with their stacks and virtual times, why nothing orders them, where. */
void race_print(const struct race_reports *t, FILE *f);
/* One line for the summary: how many there are. */
void race_print_count(const struct race_reports *t, FILE *f);
/* What is wrong, in one line; why, in sentences; "3", "0-15, host". Malloc'd. */
char *race_print_head(const struct race_report *r);
char *race_print_why(const struct race_report *r);
char *race_print_nodes(const struct race_report *r);
#endif
