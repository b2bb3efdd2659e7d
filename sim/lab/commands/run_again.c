/* run_again.c - see run_again.h. */
#include "lab/commands/run_again.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "cli/commands.h"
#include "lab/commands/lab_commands.h"
#include "kernel/xalloc.h"

/* A machine file that is named relative to the folder of the run, as a path from anywhere; or its name.
 * malloc'd. */
static char *machine_of(const char *folder, const char *machine)
{
    size_t n = strlen(machine);
    bool is_path = strchr(machine, '/') || (n >= 4 && !strcmp(machine + n - 4, ".cfg"));
    return is_path && *machine != '/' ? xasprintf("%s/%s", folder, machine) : xstrdup(machine);
}

static int count_of(char *const *argv)
{
    int count = 0;
    while (argv && argv[count])
        count++;
    return count;
}

/* The options that say what runs, ended by NULL. */
static void make_options(const struct cli_run_parts *parts, const char *runner, struct run_again *again)
{
    size_t settings = 0, files = 0;
    while (parts->what.set[settings])
        settings++;
    while (parts->host_files && parts->host_files[files])
        files++;
    const char **o = xcalloc(10 + 2 * (settings + files), sizeof *o);
    again->options = (char **)(uintptr_t)o;
    again->nodes = xasprintf("%u", parts->what.nodes);
    *o++ = runner, *o++ = "run", *o++ = "-q";
    *o++ = "-m", *o++ = again->machine;
    if (parts->what.nodes)
        *o++ = "-n", *o++ = again->nodes;
    if (parts->what.host)
        *o++ = "--host", *o++ = parts->what.host;
    for (size_t i = 0; i < settings; i++)
        *o++ = "--set", *o++ = parts->what.set[i];
    for (size_t i = 0; i < files; i++)
        *o++ = "--host-files", *o++ = parts->host_files[i];
}

bool run_again_of(const struct cli_run_parts *parts, const char *folder,
                  const struct cli_installation *places, struct run_again *again, char **error)
{
    *again = (struct run_again){.machine = machine_of(folder, parts->what.machine)};
    make_options(parts, places->runner, again);
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
    int argc = count_of(t->argv);
    *again = (struct run_again){0};
    if (argc < 2 || strcmp(t->argv[1], "run")) {
        *error = xasprintf("%s does not say which command made it", t->path);
        return false;
    }
    struct cli_run_parts parts;
    cli_run_read(argc - 1, t->argv + 1, &parts);
    bool good = run_again_of(&parts, t->folder, places, again, error);
    free(parts.what.set);
    free(parts.host_files);
    return good;
}

char *run_again_refuses(const struct run_again *again, const struct cli_installation *places,
                        const char *const set[])
{
    size_t count = 0, more = 0;
    while (set[more])
        more++;
    const char **all = xcalloc((size_t)count_of(again->options) + more + 1, sizeof *all);
    for (char **o = again->options; o[0] && o[1]; o++)
        if (!strcmp(o[0], "--set"))
            all[count++] = *++o;
    memcpy(all + count, set, more * sizeof *all);
    char *error = NULL;
    cfg_free(cfg_load_with(again->machine, places->machines, all, &error));
    free(all);
    return error;
}

void run_again_free(struct run_again *again)
{
    free(again->options);
    free(again->nodes);
    free(again->machine);
    cfg_free(again->cfg);
    *again = (struct run_again){0};
}
