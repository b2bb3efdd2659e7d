/* studies.c - see studies.h. */
#include "cli/studies.h"
#include "config/config.h"
#include "lab/jobs/result_cache.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool cli_studies_begin(struct cli_studies *s, const char *command, unsigned jobs, const char *cache,
                       bool no_cache, struct study_options *options)
{
    s->cache = NULL;
    if (!cfg_home(s->home, sizeof s->home) || !cli_find_programs(s->runner, s->programs)) {
        fprintf(
            stderr,
            "touchstone %s: machines/ is not where this program was built or installed; set TOUCHSTONE_HOME\n",
            command);
        return false;
    }
    snprintf(s->machines, sizeof s->machines, "%s/machines", s->home);
    s->cache = no_cache ? NULL : cache ? strdup(cache) : result_cache_folder();
    *options = (struct study_options){.runner = s->runner,
                                      .programs = s->programs,
                                      .machines = s->machines,
                                      .cache = s->cache,
                                      .session = "",
                                      .at_once = jobs ? jobs : cli_processors(),
                                      .out = stdout,
                                      .progress = stderr};
    return true;
}

void cli_studies_folder(const char *file, const char *suffix, char dir[PATH_MAX])
{
    const char *slash = strrchr(file, '/'), *name = slash ? slash + 1 : file, *dot = strrchr(name, '.');
    snprintf(dir, PATH_MAX, "out/%.*s%s", (int)(dot && dot > name ? (size_t)(dot - name) : strlen(name)),
             name, suffix);
}

void cli_studies_end(struct cli_studies *s)
{
    free(s->cache);
}
