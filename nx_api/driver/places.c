/* places.c - see places.h. */
#include "nx_api/driver/places.h"
#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "nx_api/driver/text.h"

static bool readable(const char *path)
{
    return access(path, R_OK) == 0;
}

static bool readable_in(const char *directory, const char *name)
{
    char *path = text("%s/%s", directory, name);
    bool yes = readable(path);
    free(path);
    return yes;
}

char *places_self(void)
{
    char self[PATH_MAX];
    ssize_t n = readlink("/proc/self/exe", self, sizeof self);
    if (n < 0)
        fail("/proc/self/exe: %s", strerror(errno));
    return text("%.*s", (int)n, self);
}

char *places_folder(void)
{
    char *self = places_self();
    *strrchr(self, '/') = '\0';
    return self;
}

struct places places_find(void)
{
    char *self = places_folder();
    char *built = text("%s/node", self);
    if (readable_in(built, "count.so"))
        return (struct places){.lib = built,
                               .include = text("%s/include", built),
                               .cpu = text("%s/cpu", built),
                               .mpi_include = text("%s/mpi_include", built)};
    free(built);
    struct places p = {
        .lib = text("%s/../lib/touchstone", self),
        .include = text("%s/../share/touchstone/include", self),
        .cpu = text("%s/../share/touchstone/cpu", self),
        .mpi_include = text("%s/../share/touchstone/mpi_include", self),
    };
    if (!readable_in(p.lib, "count.so"))
        fail("count.so is neither in %s/node (build tree) nor in %s (installed): is the installation "
             "complete?",
             self, p.lib);
    return p;
}

bool places_is_mpi_library(const char *file)
{
    const char *slash = strrchr(file, '/');
    if (!slash || strcmp(slash, "/libmpi.a"))
        return false;
    struct places p = places_find();
    char *own = text("%s/libmpi.a", p.lib);
    struct stat a, b;
    bool same = !stat(file, &a) && !stat(own, &b) && a.st_dev == b.st_dev && a.st_ino == b.st_ino;
    free(own);
    return same;
}

char *places_costs(const struct places *p, const char *name)
{
    if (readable(name))
        return realpath(name, NULL);
    char *own = text("%s/%s", p->cpu, name);
    if (!strchr(name, '/') && readable(own))
        return own;
    free(own);
    fail("--costs %s: %s (looked for it here and in %s)", name, strerror(errno), p->cpu);
}
