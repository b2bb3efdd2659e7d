/* compare_print.h - what came of comparisons (compare.h): for people, and as JUnit XML for what shows test results. */
#ifndef LAB_CHECK_COMPARE_PRINT_H
#define LAB_CHECK_COMPARE_PRINT_H
#include <stdio.h>

#include "lab/check/compare.h"

/* A point's figures that differ, and where its time moved: several lines, or none if nothing differs. */
void compare_print(const struct compare_point *p, FILE *out);
/* The same in one line. */
void compare_print_short(const struct compare_point *p, FILE *out);

/* One test case a point, of class "touchstone.STUDY", its time the virtual one; so the file is the same whenever the
 * results are. Worse and missing points are failures, failed ones errors; what is told of others is their output. */
void junit_write(struct compare_point *const points[], size_t count, FILE *out);
#endif
