/* compare_print.h - comparisons (compare.h) as text for people. */
#ifndef LAB_CHECK_COMPARE_PRINT_H
#define LAB_CHECK_COMPARE_PRINT_H
#include <stdio.h>

#include "lab/check/compare.h"

/* Prints a point's figures that differ, and where its time moved: several lines, or none if nothing
 * differs. */
void compare_print(const struct compare_point *p, FILE *out);
/* Prints the comparison in one line. */
void compare_print_short(const struct compare_point *p, FILE *out);
#endif
