/* ink.h - colours of text for people: the escape sequences of a terminal. What is no terminal gets none. */
#ifndef FILES_INK_H
#define FILES_INK_H
#include <stdio.h>

/* To be written before a text, and off behind it. */
struct ink {
    const char *bold, *red, *yellow, *green, *off;
};

/* For text to f: colours if f is a terminal that knows them ($TERM is set, and not to dumb), or if
 * $CLICOLOR_FORCE is set, and not to 0; but not if $NO_COLOR is set, and never if f is a buffer in memory.
 * (What mpirun gives its processes as standard output looks like a terminal, and may become a file.) */
struct ink ink_for(FILE *f);
#endif
