/* study_session.c - see study_session.h. */
#include "lab/commands/study_session.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cli/host_files.h"
#include "kernel/xalloc.h"
#include "lab/jobs/result_cache.h"

static const struct argp_option OPTIONS[] = {
    {"cache", CLI_TEXT(cli_session_options, cache), "DIR", 0,
     "Keep results in DIR for all studies; default $XDG_CACHE_HOME/touchstone or ~/.cache/touchstone", 1},
    {"no-cache", CLI_FLAG(cli_session_options, no_cache), NULL, 0,
     "Keep no results for other studies, and take none", 1},
    {0}};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    if (key != ARGP_KEY_INIT)
        return cli_store(key, arg, state);
    state->child_inputs[0] = &((struct cli_session_options *)state->input)->jobs;
    return 0;
}

static const struct argp_child CHILDREN[] = {
    {&CLI_JOBS, 0, NULL, 0}, {&CLI_RUNS_HOST_FILES, 0, NULL, 0}, {0}};
const struct argp CLI_SESSION = {OPTIONS, parse, NULL, NULL, CHILDREN, NULL, NULL};

error_t cli_study_argument(int key, char *arg, struct argp_state *state, struct cli_study_arguments *a)
{
    if (key == 'o')
        a->dir = arg;
    else if (key == ARGP_KEY_ARG)
        return cli_store_only(&a->file, arg);
    else if (key == ARGP_KEY_NO_ARGS)
        argp_error(state, "which study file?");
    else
        return cli_store(key, arg, state);
    return 0;
}

bool cli_session_begin(struct cli_session *s, const char *command, const struct cli_session_options *options,
                       struct study_options *study)
{
    if (!cli_find_installation(&s->places, command))
        return false;
    s->cache = options->no_cache ? NULL : options->cache ? xstrdup(options->cache) : result_cache_folder();
    *study = (struct study_options){.runner = s->places.runner,
                                    .programs = s->places.programs,
                                    .machines = s->places.machines,
                                    .cache = s->cache,
                                    .session = "",
                                    .at_once = cli_jobs(options->jobs),
                                    .out = stdout,
                                    .progress = stderr};
    return true;
}

void cli_session_silence(struct study_options *study)
{
    FILE *nowhere = fopen("/dev/null", "we");
    study->progress = nowhere ? nowhere : stderr;
}

void cli_session_end(struct cli_session *s, const struct study_options *study)
{
    if (study->progress != stderr)
        fclose(study->progress);
    free(s->cache);
}

void cli_default_folder(const char *file, const char *suffix, char dir[PATH_MAX])
{
    const char *name = basename(file), *dot = strrchr(name, '.');
    snprintf(dir, PATH_MAX, "out/%.*s%s", (int)(dot && dot > name ? (size_t)(dot - name) : strlen(name)),
             name, suffix);
}
