/* shared_objects.c - libraries that a program would load while it runs. A node has none: dlopen fails, as it
 * may, and dlerror says why. Programs load plugins so, and do without them. */
#include <dlfcn.h>
#include <stddef.h>

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
