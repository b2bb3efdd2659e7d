/* temporary.c - see temporary.h. */
#include "nx_api/driver/temporary.h"
#include <errno.h>
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx_api/driver/text.h"

char *temporary_folder(void)
{
    const char *tmp = getenv("TMPDIR");
    char *folder = text("%s/nxccXXXXXX", tmp && *tmp ? tmp : P_tmpdir);
    if (!mkdtemp(folder))
        fail("%s: %s", folder, strerror(errno));
    return folder;
}

static int remove_one(const char *path, const struct stat *s, int kind, struct FTW *place)
{
    (void)s, (void)kind, (void)place;
    remove(path);
    return 0;
}

void temporary_remove(char *folder)
{
    enum { OPEN = 8 };
    nftw(folder, remove_one, OPEN, FTW_DEPTH | FTW_PHYS);
    free(folder);
}
