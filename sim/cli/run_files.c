/* run_files.c - see run_files.h. */
#include "cli/run_files.h"
#include <stdlib.h>

static char *begin(struct atomic_file *f, const char *path)
{
    char *error = NULL;
    if (!path)
        return NULL;
    atomic_file_remove_left(path);
    atomic_file_reserve(f, path, &error);
    return error;
}

static char *end(struct atomic_file *f)
{
    char *error = NULL;
    if (f->out)
        atomic_file_end(f, &error);
    return error;
}

static void drop(struct atomic_file *f)
{
    if (f->out)
        atomic_file_drop(f);
}

char *run_files_begin(struct run_files *f, const char *history, const char *schedule)
{
    *f = (struct run_files){0};
    char *error = begin(&f->history, history);
    if (error)
        return error;
    error = begin(&f->schedule, schedule);
    if (error)
        drop(&f->history);
    return error;
}

void run_files_replace(struct run_files *f)
{
    if (f->history.out)
        atomic_file_replace(&f->history);
    if (f->schedule.out)
        atomic_file_replace(&f->schedule);
}

char *run_files_end(struct run_files *f)
{
    char *error = end(&f->history), *other = end(&f->schedule);
    if (!error)
        return other;
    free(other);
    return error;
}

void run_files_drop(struct run_files *f)
{
    drop(&f->history);
    drop(&f->schedule);
}
