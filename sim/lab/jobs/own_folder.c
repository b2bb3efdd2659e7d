/* own_folder.c - see own_folder.h. */
#include "lab/jobs/own_folder.h"
#include <dirent.h>
#include <errno.h>
#include <fts.h>
#include <limits.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "kernel/xalloc.h"

/* Has the file changed after that time? What is no file has not. */
static bool is_later(const char *path, const struct timespec *time)
{
    struct stat st;
    return time && !stat(path, &st) && S_ISREG(st.st_mode) &&
           (st.st_ctim.tv_sec != time->tv_sec ? st.st_ctim.tv_sec > time->tv_sec
                                              : st.st_ctim.tv_nsec > time->tv_nsec);
}

/* What the folder is made of. */
struct plan {
    const char *path, *like, *except;
    const struct timespec *until;
};

/* Where the link of that name leads to; malloc'd. NULL: the folder has none. */
static char *wanted(const struct plan *p, const char *name)
{
    char *from = xasprintf("%s/%s", p->like, name);
    struct stat st;
    if (!strcmp(name, ".") || !strcmp(name, "..") || (p->except && !strcmp(name, p->except)) ||
        lstat(from, &st) || is_later(from, p->until)) {
        free(from);
        return NULL;
    }
    return from;
}

static bool leads_to(const char *link, const char *from)
{
    char now[PATH_MAX];
    ssize_t length = readlink(link, now, sizeof now);
    return length > 0 && (size_t)length == strlen(from) && !memcmp(now, from, (size_t)length);
}

static void link_one(const struct plan *p, const char *name)
{
    char *from = wanted(p, name), *to = xasprintf("%s/%s", p->path, name);
    int made = from ? symlink(from, to) : 0;
    (void)made; /* without the link the program misses the file, and says so */
    free(from);
    free(to);
}

static void remove_other(const struct plan *p, const char *name)
{
    char *from = wanted(p, name), *to = xasprintf("%s/%s", p->path, name);
    if (strcmp(name, ".") && strcmp(name, "..") && !(from && leads_to(to, from)))
        own_folder_remove(to);
    free(from);
    free(to);
}

static bool for_all(const struct plan *p, const char *folder,
                    void (*what)(const struct plan *p, const char *name))
{
    DIR *all = opendir(folder);
    if (!all)
        return false;
    for (struct dirent *e; (e = readdir(all));)
        what(p, e->d_name);
    closedir(all);
    return true;
}

bool own_folder_make(const char *path, const char *like, const char *except, const struct timespec *until)
{
    const struct plan p = {path, like, except, until};
    if (!mkdir(path, 0700) || (errno == EEXIST && for_all(&p, path, remove_other)))
        return for_all(&p, like, link_one);
    return false;
}

/* How many folders up the name begins. */
static size_t steps_up(const char *name)
{
    size_t steps = 0;
    for (; !strncmp(name, "../", 3); name += 3)
        steps++;
    return steps + !strcmp(name, "..");
}

static size_t most_steps_up(char *const *words)
{
    size_t most = 0;
    for (; *words; words++) {
        const char *equals = strchr(*words, '=');
        size_t steps = steps_up(*words);
        if (steps == 0 && equals)
            steps = steps_up(equals + 1);
        most = steps > most ? steps : most;
    }
    return most;
}

char *own_folder_place(const char *scratch, const char *like, char *const *words)
{
    char *place = xstrdup(scratch), *above = xstrdup(like);
    size_t steps = most_steps_up(words);
    for (size_t i = 0; i < steps; i++) {
        char *higher = xasprintf("%s/..", above);
        free(above);
        above = higher;
    }
    for (size_t i = steps; i > 0 && place; i--) {
        char *lower = xasprintf("%s/.touchstone", place);
        free(place);
        place = lower;
        if (!own_folder_make(place, above, NULL, NULL)) {
            free(place);
            place = NULL;
        }
        above[strlen(above) - strlen("/..")] = '\0';
    }
    free(above);
    return place;
}

void own_folder_remove(const char *path)
{
    char *const roots[] = {(char *)(uintptr_t)path, NULL};
    FTS *tree = fts_open(roots, FTS_PHYSICAL | FTS_NOCHDIR, NULL);
    if (!tree)
        return;
    for (FTSENT *e; (e = fts_read(tree));)
        if (e->fts_info == FTS_DP)
            rmdir(e->fts_path);
        else if (e->fts_info != FTS_D)
            unlink(e->fts_path);
    fts_close(tree);
}
