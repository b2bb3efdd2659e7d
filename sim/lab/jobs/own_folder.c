/* own_folder.c - see own_folder.h. */
#include "lab/jobs/own_folder.h"
#include <dirent.h>
#include <errno.h>
#include <limits.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "files/left_over.h"
#include "kernel/xalloc.h"
#include "files/words.h"

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

/* What of the exception's path is in the folder of that name; "" if the path is the name itself, NULL if it
 * is another one. */
static const char *exception_in(const struct plan *p, const char *name)
{
    size_t length = strlen(name);
    if (!p->except || strncmp(p->except, name, length) || (p->except[length] && p->except[length] != '/'))
        return NULL;
    return p->except + length + strspn(p->except + length, "/");
}

/* Where the link of that name leads to; malloc'd. NULL: the folder has none. */
static char *wanted(const struct plan *p, const char *name)
{
    char *from = xasprintf("%s/%s", p->like, name);
    struct stat st;
    if (!strcmp(name, ".") || !strcmp(name, "..") || exception_in(p, name) || lstat(from, &st) ||
        is_later(from, p->until)) {
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

/* A folder in which the exception is becomes a folder of its own, too. */
static void link_one(const struct plan *p, const char *name)
{
    const char *inner = exception_in(p, name);
    char *from = wanted(p, name), *to = xasprintf("%s/%s", p->path, name);
    int made = from ? symlink(from, to) : 0;
    (void)made; /* without the link the program misses the file, and says so */
    if (inner && *inner) {
        char *like = xasprintf("%s/%s", p->like, name);
        own_folder_make(to, like, inner, p->until);
        free(like);
    }
    free(from);
    free(to);
}

static void remove_other(const struct plan *p, const char *name)
{
    char *from = wanted(p, name), *to = xasprintf("%s/%s", p->path, name);
    if (strcmp(name, ".") && strcmp(name, "..") && !(from && leads_to(to, from)))
        left_over_remove(to);
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
    struct stat st;
    bool made = !mkdir(path, 0700);
    if (!made && errno == EEXIST && !lstat(path, &st) && S_ISDIR(st.st_mode)) /* and no link to another */
        made = for_all(&p, path, remove_other);
    return made && for_all(&p, like, link_one);
}

/* How many folders up the name begins. */
static size_t steps_up(const char *name)
{
    size_t steps = 0;
    for (; !strncmp(name, "../", 3); name += 3)
        steps++;
    return steps + !strcmp(name, "..");
}

/* The name in a word: NAME, or KEY=NAME. */
static const char *name_in(const char *word)
{
    const char *equals = strchr(word, '=');
    return equals && !steps_up(word) ? equals + 1 : word;
}

static char *above(const char *folder, size_t steps)
{
    char *path = xstrdup(folder);
    for (; steps; steps--)
        words_append(&path, "/..");
    return path;
}

/* Links the first folder, or the file, that the name leads to. */
static void link_above(const char *place, const char *like, const char *name)
{
    size_t steps = steps_up(name);
    const char *first = name + 3 * steps;
    if (!steps || !strcmp(name + 3 * (steps - 1), "..") || !*first)
        return;
    char *from = above(like, steps), *to = above(place, steps - 1);
    const struct plan p = {.path = to, .like = from};
    char *part = xstrndup(first, strcspn(first, "/"));
    link_one(&p, part);
    free(part);
    free(from);
    free(to);
}

char *own_folder_place(const char *scratch, const char *like, char *const *words)
{
    char *place = xstrdup(scratch);
    size_t steps = 0;
    for (char *const *w = words; *w; w++)
        steps = steps_up(name_in(*w)) > steps ? steps_up(name_in(*w)) : steps;
    for (; steps; steps--) {
        words_append(&place, "/.touchstone");
        if (mkdir(place, 0700)) {
            free(place);
            return NULL;
        }
    }
    for (; *words; words++)
        link_above(place, like, name_in(*words));
    return place;
}
