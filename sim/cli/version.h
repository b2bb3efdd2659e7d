/* version.h - the version of touchstone. */
#ifndef CLI_VERSION_H
#define CLI_VERSION_H
#include <stdio.h>

extern const char CLI_VERSION[]; /* "0.1": the file VERSION */

/* For --version: version, commit, the formats of its files, the compiler. The commit is read from a file that
 * the build leaves beside the node programs' libraries. Compiled in, it would have each commit link all anew,
 * and void the results of studies, which depend on the simulator's bytes. */
void cli_version_print(FILE *f);
#endif
