/* unreached.h - tells the user why a surface has no polygons. */
#ifndef UNREACHED_H
#define UNREACHED_H
#include "options.h"

/* Prints a line on standard error for each surface of which there are no polygons. Reads the volume once more
 * if there is such a surface. */
void unreached_say(const struct options *o, const double *polygons);

#endif
