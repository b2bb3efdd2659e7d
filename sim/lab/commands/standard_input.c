/* standard_input.c - see standard_input.h. */
#include "lab/commands/standard_input.h"
#include <errno.h>
#include <unistd.h>
#include "kernel/xalloc.h"

bool standard_input_read(char **input, size_t *bytes, char **error)
{
    enum { PART = 1 << 16 };
    ssize_t got = isatty(STDIN_FILENO) ? 0 : 1;
    while (got > 0) {
        *input = xrealloc(*input, *bytes + PART);
        got = read(STDIN_FILENO, *input + *bytes, PART);
        *bytes += got > 0 ? (size_t)got : 0;
    }
    if (got < 0 && errno != EBADF)
        *error = xasprintf("standard input cannot be read: %m");
    return !*error;
}
