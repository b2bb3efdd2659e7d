/* touchstone_home.c - see touchstone_home.h. */
#include "config/touchstone_home.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* machines/cpu and not just machines/: a folder above may happen to have that name. */
static bool holds_machines(const char *dir)
{
    char path[PATH_MAX];
    struct stat st;
    int n = snprintf(path, sizeof path, "%s/machines/cpu", dir);
    return n > 0 && (size_t)n < sizeof path && stat(path, &st) == 0 && S_ISDIR(st.st_mode);
}

static bool try_home(char *buf, size_t size, const char *dir, const char *below)
{
    int n = snprintf(buf, size, "%s%s", dir, below);
    return n > 0 && (size_t)n < size && holds_machines(buf);
}

bool cfg_home(char *buf, size_t size)
{
    const char *set = getenv("TOUCHSTONE_HOME");
    if (set && *set)
        return try_home(buf, size, set, "");

    char exe[PATH_MAX];
    ssize_t n = readlink("/proc/self/exe", exe, sizeof exe - 1);
    if (n <= 0)
        return false;
    exe[n] = '\0';
    /* bin/touchstone finds ../share/touchstone; build/touchstone, build/asan/touchstone and the tests in
     * build/tests/ find the tree they were built in. */
    for (char *slash = strrchr(exe, '/'); slash && slash > exe; slash = strrchr(exe, '/')) {
        *slash = '\0';
        if (try_home(buf, size, exe, "/share/touchstone") || try_home(buf, size, exe, ""))
            return true;
    }
    return false;
}
