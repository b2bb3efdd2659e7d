/* fit_build.c - cost factors as parameters: builds the program for each of their values, by the study file's
 * command. Builds of equal bytes are the same point. */
#include "files/atomic_file.h"
#include "files/folder_make.h"
#include "kernel/xalloc.h"
#include "lab/fit/fit_parts.h"
#include "lab/jobs/process_pool.h"
#include "files/words.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* The text of a file of factors for nxcc; malloc'd. */
static char *factors_of(const struct fit *f, const double position[])
{
    char *list = xasprintf("factors = (");
    const char *mark = "";
    for (size_t i = 0; i < f->parameters; i++) {
        char value[32];
        if (!f->parameter[i].factor)
            continue;
        fit_text(&f->parameter[i], position[i], value);
        words_append(&list, "%s\n    { file = \"%s\"; factor = %s%s; }", mark, f->parameter[i].factor, value,
                     strpbrk(value, ".e") ? "" : ".0");
        mark = ",";
    }
    words_append(&list, "\n);\n");
    return list;
}

/* The command with the path in place of {name}, also of one in quotes: it is quoted where a shell needs it.
 * malloc'd. */
static char *with_path(const char *command, const char *name, const char *path)
{
    char *word = words_quoted(path), *text = xstrdup(command);
    static const char *const QUOTES[] = {"\"", "'", ""};
    for (size_t i = 0; i < sizeof QUOTES / sizeof *QUOTES; i++) {
        char *hole = xasprintf("%s{%s}%s", QUOTES[i], name, QUOTES[i]),
             *filled = words_filled(text, hole, word);
        free(hole);
        free(text);
        text = filled;
    }
    free(word);
    return text;
}

/* Runs the build command by the shell, in the study file's folder. */
static bool command(struct fit *f, const char *factors)
{
    const char *file = f->options->study.file, *slash = strrchr(file, '/');
    char *dir = slash ? xasprintf("%.*s", (int)(slash - file + 1), file) : xasprintf(".");
    char *with = with_path(f->build, "factors", factors), *all = with_path(with, "program", f->program);
    char *const argv[] = {"/bin/sh", "-c", all, NULL};
    struct pool_job job = {.name = "build", .argv = argv, .dir = dir};
    struct pool_end end = pool_run(&job, 1, 1, NULL);
    bool good = end.all_done && job.state == POOL_DONE;
    *f->options->signal = end.stopped;
    if (!good)
        f->error = end.stopped ? xasprintf("stopped by a signal; the same command goes on from here")
                               : xasprintf("%s: build: %s", file, job.error ? job.error : "not run");
    pool_clear(&job, 1);
    free(all);
    free(with);
    free(dir);
    return good;
}

/* The absolute path of a file in the fit's folder; malloc'd. */
static char *path_of(const struct fit *f, const char *name)
{
    char real[PATH_MAX];
    const char *dir = f->options->study.dir;
    return xasprintf("%s/%s", folder_make(dir) && realpath(dir, real) ? real : dir, name);
}

bool fit_build(struct fit *f, const double position[])
{
    if (!f->build)
        return true;
    char *text = factors_of(f, position);
    if (f->built && strcmp(text, f->built) == 0) {
        free(text);
        return true;
    }
    char *factors = path_of(f, "factors.cfg");
    if (!f->program)
        f->program = path_of(f, "program");
    bool good = atomic_file_write(factors, text, strlen(text), &f->error) && command(f, factors);
    free(factors);
    free(f->built);
    f->built = text;
    return good;
}
