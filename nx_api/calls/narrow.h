/* narrow.h - what narrow.c needs of what serves the calls: the standard streams of the program that calls. */
#ifndef CALLS_NARROW_H
#define CALLS_NARROW_H
#include <stdio.h>

FILE *nx_output(void);
FILE *nx_input(void);

#endif
