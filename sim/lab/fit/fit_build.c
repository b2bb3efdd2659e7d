/* fit_build.c - cost factors as parameters: the program is built anew for each value of them, by the command that the study
 * file gives. Equal bytes of a program are the same point, however often it was built. */
#include "files/folder_make.h"
#include "kernel/xalloc.h"
#include "lab/fit/fit_parts.h"
#include "lab/jobs/process_pool.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

char *fit_filled(const char *text, const char *hole, const char *with)
{
    char *done = xstrdup("");
    for (const char *at; (at = strstr(text, hole)); text = at + strlen(hole)) {
        char *longer = xasprintf("%s%.*s%s", done, (int)(at - text), text, with);
        free(done);
        done = longer;
    }
    char *all = xasprintf("%s%s", done, text);
    free(done);
    return all;
}

/* The file of factors that nxcc reads; malloc'd. */
static char *factors_of(const struct fit *f, const double place[])
{
    char *list = xasprintf("factors = (");
    const char *mark = "";
    for (size_t i = 0; i < f->parameters; i++) {
        char value[32];
        if (!f->parameter[i].factor)
            continue;
        fit_text(&f->parameter[i], place[i], value);
        char *longer = xasprintf("%s%s\n    { file = \"%s\"; factor = %s%s; }", list, mark,
                                 f->parameter[i].factor, value, strpbrk(value, ".e") ? "" : ".0");
        free(list);
        list = longer;
        mark = ",";
    }
    char *all = xasprintf("%s\n);\n", list);
    free(list);
    return all;
}

static bool write_file(const char *path, const char *text)
{
    FILE *out = fopen(path, "we");
    if (!out)
        return false;
    bool written = fputs(text, out) >= 0;
    return fclose(out) == 0 && written;
}

/* By the shell, in the study file's folder. */
static bool command(struct fit *f, const char *factors)
{
    const char *file = f->options->study.file, *slash = strrchr(file, '/');
    char *dir = slash ? xasprintf("%.*s", (int)(slash - file + 1), file) : xasprintf(".");
    char *with = fit_filled(f->build, "{factors}", factors), *all = fit_filled(with, "{program}", f->program);
    char *const argv[] = {"/bin/sh", "-c", all, NULL};
    struct pool_job job = {.name = "build", .argv = argv, .dir = dir};
    struct pool_end end = pool_run(&job, 1, 1, NULL);
    bool good = end.all_done && job.state == POOL_DONE;
    if (!good)
        f->error = end.stopped ? xasprintf("stopped by a signal; the same command goes on from here")
                               : xasprintf("%s: build: %s", file, job.error ? job.error : "not run");
    pool_clear(&job, 1);
    free(all);
    free(with);
    free(dir);
    return good;
}

/* Where files of the fit are, as an absolute path. */
static char *place_of(const struct fit *f, const char *name)
{
    char real[PATH_MAX];
    const char *dir = f->options->study.dir;
    return xasprintf("%s/%s", folder_make(dir) && realpath(dir, real) ? real : dir, name);
}

bool fit_build(struct fit *f, const double place[])
{
    if (!f->build)
        return true;
    char *text = factors_of(f, place);
    if (f->built && strcmp(text, f->built) == 0) {
        free(text);
        return true;
    }
    char *factors = place_of(f, "factors.cfg");
    if (!f->program)
        f->program = place_of(f, "program");
    bool good = write_file(factors, text);
    if (!good)
        f->error = xasprintf("%s: %m", factors);
    good = good && command(f, factors);
    free(factors);
    free(f->built);
    f->built = text;
    return good;
}
