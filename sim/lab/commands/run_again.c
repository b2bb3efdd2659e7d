/* run_again.c - see run_again.h. */
#include "lab/commands/run_again.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "cli/commands.h"
#include "lab/commands/lab_commands.h"
#include "kernel/xalloc.h"
#include "files/words.h"

/* A machine file that is named relative to the folder of the run, as a path from anywhere; or its name.
 * malloc'd. */
static char *machine_of(const char *folder, const char *machine)
{
    return cfg_is_path(machine) && *machine != '/' ? xasprintf("%s/%s", folder, machine) : xstrdup(machine);
}

/* The options that say what runs. */
static char **options_of(const struct cli_run_parts *parts, const char *runner, const char *machine)
{
    const struct cli_program *what = &parts->what;
    char **o = NULL;
    words_add_each(&o, NULL, (const char *const[]){runner, "run", "-q", "-m", machine, NULL});
    if (what->nodes)
        words_add_option(&o, "-n", xasprintf("%u", what->nodes));
    if (what->host)
        words_add_option(&o, "--host", xstrdup(what->host));
    words_add_each(&o, "--set", what->set);
    words_add_each(&o, "--host-files", parts->host_files);
    return o;
}

bool run_again_of(const struct cli_run_parts *parts, const char *folder,
                  const struct cli_installation *places, struct run_again *again, char **error)
{
    *again = (struct run_again){.machine = machine_of(folder, parts->what.machine)};
    again->options = options_of(parts, places->runner, again->machine);
    again->cfg = cfg_load_with(again->machine, places->machines, parts->what.set, error);
    again->command = (struct rerun_command){
        .options = again->options, .program = parts->what.program, .cfs = parts->cfs, .folder = folder};
    if (!again->cfg)
        run_again_free(again);
    return again->cfg != NULL;
}

bool run_again_from(const struct trace *t, const struct cli_installation *places, struct run_again *again,
                    char **error)
{
    int argc = 0;
    while (t->argv[argc])
        argc++;
    *again = (struct run_again){0};
    if (argc < 2 || strcmp(t->argv[1], "run")) {
        *error = xasprintf("%s does not say which command made it", t->path);
        return false;
    }
    struct cli_run_parts parts;
    cli_run_read(argc - 1, t->argv + 1, &parts);
    bool good = run_again_of(&parts, t->folder, places, again, error);
    cli_program_free(&parts.what);
    free(parts.host_files);
    return good;
}

char *run_again_refuses(const struct run_again *again, const struct cli_installation *places,
                        const char *const set[])
{
    char *error = NULL, **all = NULL;
    for (char **o = again->options; o[0] && o[1]; o++)
        if (!strcmp(o[0], "--set"))
            words_add(&all, xstrdup(*++o));
    words_add_each(&all, NULL, set);
    cfg_free(cfg_load_with(again->machine, places->machines, (const char *const *)all, &error));
    words_free(all);
    return error;
}

void run_again_free(struct run_again *again)
{
    words_free(again->options);
    free(again->machine);
    cfg_free(again->cfg);
    *again = (struct run_again){0};
}
