/* shared_objects.c - libraries that a program would load while it runs. A node has none: dlopen fails, as it
 * may, and dlerror says why. Programs load plugins so, and do without them. What is loaded is the program
 * alone: dladdr knows its addresses, and no names, as of a program that exports none. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stddef.h>

extern char __ehdr_start[], end[]; /* the program's first byte, and behind its last: the linker's */

static char *error;

static void *fails(char *why)
{
    error = why;
    return NULL;
}

void *dlopen(const char *path, int mode)
{
    (void)path, (void)mode;
    return fails("a node loads no libraries: link them with the program");
}

void *dlsym(void *restrict library, const char *restrict name)
{
    (void)library, (void)name;
    return fails("a node knows no functions by their names");
}

int dlclose(void *library)
{
    (void)library;
    fails("no such library is open");
    return -1;
}

/* Each error is told once. */
char *dlerror(void)
{
    char *last = error;
    error = NULL;
    return last;
}

/* Returns whether the address is the program's. */
int dladdr(const void *address, Dl_info *info)
{
    const char *at = address;
    if (at < __ehdr_start || at >= end)
        return 0;
    *info = (Dl_info){.dli_fname = program_invocation_name, .dli_fbase = __ehdr_start};
    return 1;
}
