/* mpi_absent.c - functions that no library has, in programs linked by nxcc --mpi --stubs:
 * nx_api/driver/stubs.c. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx_api/calls/call.h"

long node_nx_absent(const char *name) NX_EXPORT("nx_absent");

/* Returns 1 for a name that is new. The name, in the program's memory, lasts as long as the program. */
static int note(const char *name)
{
    static const char **noted;
    static size_t count;
    for (size_t i = 0; i < count; i++)
        if (strcmp(noted[i], name) == 0)
            return 0;
    const char **more = reallocarray(noted, count + 1, sizeof *noted);
    if (!more)
        abort();
    noted = more;
    noted[count++] = name;
    return 1;
}

/* Each function is reported once on each node. */
long node_nx_absent(const char *name)
{
    if (note(name))
        fprintf(stderr, "node %ld: %s failed with ENOSYS, as it is not there\n", (long)node_self()->id, name);
    errno = ENOSYS;
    return -1;
}
