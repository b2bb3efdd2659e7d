/* safe_text.h - text for standard error, made by functions that may be called in a handler of a signal. */
#ifndef MPI_SAFE_TEXT_H
#define MPI_SAFE_TEXT_H
#include <stddef.h>

struct safe_text {
    char bytes[4000]; /* what is more is left out */
    size_t count;
};

void safe_append(struct safe_text *t, const char *s);
void safe_append_number(struct safe_text *t, long number);
/* In one piece: mpirun forwards what other nodes write, too. The text is empty then. */
void safe_write(struct safe_text *t);
#endif
