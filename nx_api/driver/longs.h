/* longs.h - a program linked with --long32, of objects compiled with it and without: do they hand longs to
 * each other? */
#ifndef DRIVER_LONGS_H
#define DRIVER_LONGS_H

/* Does not return if they do: says which files, which function, and removes the program. */
void longs_check(const char *program);

#endif
