/* scratch.c - see scratch.h. */
#include "files/scratch.h"
#include "files/left_over.h"
#include "kernel/xalloc.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

/* The names of all folders that touchstone makes: what a killed one leaves is removed by any other. */
static const char *const NAMES[] = {"touchstone-cfs",     "touchstone-debugger",    "touchstone-explore",
                                    "touchstone-picture", "touchstone-sensitivity", "touchstone-serve",
                                    "touchstone-study",   "touchstone-tables",      "touchstone-why"};
enum { NAME_COUNT = sizeof NAMES / sizeof *NAMES };

/* Is entry NAME-XXXXXX, of a name that touchstone gives? */
static bool is_named(const char *entry, const void *none)
{
    (void)none;
    const char *dash = strrchr(entry, '-');
    for (int i = 0; dash && i < NAME_COUNT; i++)
        if (strlen(dash) == 7 && strlen(NAMES[i]) == (size_t)(dash - entry) &&
            strncmp(entry, NAMES[i], strlen(NAMES[i])) == 0)
            return true;
    return false;
}

struct scratch scratch_new(const char *name)
{
    const char *tmp = getenv("TMPDIR"), *folder = tmp && *tmp ? tmp : "/tmp";
    left_over_remove_all(folder, is_named, NULL);
    for (;;) {
        char *path = xasprintf("%s/%s-XXXXXX", folder, name);
        if (!mkdtemp(path)) {
            int why = errno;
            free(path);
            errno = why;
            return (struct scratch){NULL, -1};
        }
        struct scratch s = {path, left_over_lock(path, LOCK_EX)};
        if (s.lock >= 0 ? left_over_is_there(path, s.lock) : access(path, F_OK) == 0)
            return s;
        if (s.lock >= 0) /* taken for a dead process's before it was locked */
            close(s.lock);
        free(path);
    }
}

void scratch_remove(struct scratch *s)
{
    if (!s->path)
        return;
    left_over_remove(s->path);
    if (s->lock >= 0)
        close(s->lock);
    free(s->path);
    *s = (struct scratch){NULL, -1};
}
