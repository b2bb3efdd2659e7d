/* near.h - for tests: two numbers are equal but for a tolerance. */
#ifndef NEAR_H
#define NEAR_H
#include <math.h>
#define assert_near(a, b, tolerance) assert_true(fabs((a) - (b)) <= (tolerance))
#endif
