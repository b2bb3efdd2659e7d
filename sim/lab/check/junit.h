/* junit.h - comparisons (compare.h) as JUnit XML, for services that show test results. */
#ifndef LAB_CHECK_JUNIT_H
#define LAB_CHECK_JUNIT_H
#include "lab/check/compare.h"

#include <stdio.h>

/* Writes a test case for each point, of class "touchstone.STUDY". Its time is the virtual time, so that equal
 * results are equal files. Worse and missing points are failures, failed points errors; differences of other
 * points are their output. */
void junit_write(struct compare_point *const points[], size_t count, FILE *out);
#endif
