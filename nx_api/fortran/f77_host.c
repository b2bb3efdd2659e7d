/* f77_host.c - the calls of host programs (host.h), from Fortran. load and waitone, which nodes have, too,
 * are in f77_machine.c. */
#include <stdlib.h>
#include "f77_entry.h"
#include "host.h"

ENTRY void getcube_(const char *name, const char *type, const char *srm, in *keep, size_t name_bytes,
                    size_t type_bytes, size_t srm_bytes)
{
    char *names = nx_fortran_text(name, name_bytes, "getcube");
    char *types = nx_fortran_text(type, type_bytes, "getcube");
    (void)srm, (void)keep, (void)srm_bytes;
    getcube(names, types, "", 0);
    free(names);
    free(types);
}

ENTRY void attachcube_(const char *name, size_t bytes)
{
    char *text = nx_fortran_text(name, bytes, "attachcube");
    attachcube(text);
    free(text);
}

ENTRY void relcube_(const char *name, size_t bytes)
{
    char *text = nx_fortran_text(name, bytes, "relcube");
    relcube(text);
    free(text);
}

ENTRY void waitcube_(void)
{
    waitcube();
}
