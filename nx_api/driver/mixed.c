/* mixed.c - see mixed.h. Counted code of simulated nodes uses nxc_left or nxc_stack_pointer, code for a
 * cluster has polls of nxc_due; each library defines its own. */
#include "nx_api/driver/mixed.h"
#include <errno.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx_api/driver/text.h"

static bool misses_other_kind(const char *line, bool mpi)
{
    if (!mpi)
        return strstr(line, "undefined reference to `nxc_due'");
    return strstr(line, "undefined reference to `nxc_left'") ||
           strstr(line, "undefined reference to `nxc_stack_pointer'");
}

/* "/usr/bin/ld: node.o: in function `main':" - cuts node.o out of the line; NULL: the line is another. */
static const char *object_in(char *line)
{
    char *end = strstr(line, ": in function `");
    if (!end)
        return NULL;
    *end = '\0';
    char *space = strrchr(line, ' ');
    return space ? space + 1 : line;
}

/* (Of the objects that miss the same name, the linker lists the first few.) */
static void report(const char *object, bool mpi)
{
    if (mpi)
        fprintf(stderr,
                "%s: %s was compiled for simulated nodes, without --mpi: compile all objects again with "
                "--mpi, or link without\n",
                program_invocation_short_name, object);
    else
        fprintf(stderr,
                "%s: %s was compiled for a cluster, with --mpi: compile all objects again without, or link "
                "with --mpi\n",
                program_invocation_short_name, object);
}

bool mixed_report(const char *said, bool mpi)
{
    char *lines = text("%s", said), *rest = lines;
    const char *object = "an object", *reported = NULL, *next;
    for (char *line; (line = strsep(&rest, "\n"));) {
        if ((next = object_in(line))) {
            object = reported && !strcmp(reported, next) ? reported : next;
        } else if (object != reported && misses_other_kind(line, mpi)) {
            report(object, mpi);
            reported = object;
        }
    }
    free(lines);
    return reported;
}
