/* narrow.h - formats of programs whose long has 32 bits (nxcc --long32). */
#ifndef CALLS_NARROW_H
#define CALLS_NARROW_H
#include <stdbool.h>

/* The format with %ld as %d, for free(). scans: sets may be in it. */
char *nx_narrowed(const char *format, bool scans);
#endif
