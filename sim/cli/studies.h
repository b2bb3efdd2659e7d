/* studies.h - what the subcommands that run studies have in common: their places, their jobs and their cache. */
#ifndef CLI_STUDIES_H
#define CLI_STUDIES_H
#include "cli/cli.h"
#include "lab/study/study.h"

struct cli_studies {
    char home[PATH_MAX], machines[PATH_MAX + 16], runner[PATH_MAX], programs[CLI_MAX_PROGRAMS];
    char *cache;
};

/* Options that are filled in but for file and dir; they point into s. cache: its folder, NULL the default one; no_cache:
 * none. False, with a message on stderr, if touchstone's own files are not found. */
bool cli_studies_begin(struct cli_studies *s, const char *command, unsigned jobs, const char *cache,
                       bool no_cache, struct study_options *options);
/* Where the results of .../NAME.cfg go if nothing else is said: out/NAME and the suffix. */
void cli_studies_folder(const char *file, const char *suffix, char dir[PATH_MAX]);
void cli_studies_end(struct cli_studies *s);
#endif
