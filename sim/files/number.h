/* number.h - reads numbers from text, and writes counts for people. */
#ifndef FILES_NUMBER_H
#define FILES_NUMBER_H
#include <stdbool.h>
#include <stdint.h>

/* Reads the decimal number that text is from end to end. Unless unit is NULL, sets *unit to one in the last
 * digit as written: 90.7 has 0.1, 9e2 has 100. False if text is no finite decimal number. */
bool number_read(const char *text, double *value, double *unit);

/* "1,234,567". */
struct number_text {
    char text[28];
};
struct number_text number_grouped(uint64_t count);
#endif
