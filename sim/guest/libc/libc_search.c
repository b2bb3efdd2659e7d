/* libc_search.c - sorting and searching with a function of the program's, which runs on the program's
 * stack. Elements are compared in the order in which glibc compares them: the function may have side
 * effects, and costs time. */
#include <dlfcn.h>
#include <search.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/crossing.h"

/* The C library's own qsort_r. In builds with sanitizers the name is theirs, whose function compares all
 * neighbours first. */
static void sort(void *base, size_t count, size_t bytes, int (*order)(const void *, const void *, void *),
                 void *with)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    void *library = dlopen("libc.so.6", RTLD_LAZY | RTLD_NOLOAD);
    void (*own)(void *, size_t, size_t, int (*)(const void *, const void *, void *), void *);
    *(void **)&own = dlsym(library, "qsort_r");
    own(base, count, bytes, order, with);
    dlclose(library);
#else
    qsort_r(base, count, bytes, order, with);
#endif
}

static int compare(void *function, const void *a, const void *b)
{
    return (int)crossing_call(function, (long)a, (long)b, 0, 0, 0);
}

static int compare_for_qsort(const void *a, const void *b, void *function)
{
    return compare(function, a, b);
}

void node_qsort(void *base, size_t count, size_t bytes, void *function);
void node_qsort(void *base, size_t count, size_t bytes, void *function)
{
    sort(base, count, bytes, compare_for_qsort, function);
}

struct with_argument {
    void *function, *argument;
};

static int compare_for_qsort_r(const void *a, const void *b, void *with)
{
    const struct with_argument *w = with;
    return (int)crossing_call(w->function, (long)a, (long)b, (long)w->argument, 0, 0);
}

void node_qsort_r(void *base, size_t count, size_t bytes, void *function, void *argument);
void node_qsort_r(void *base, size_t count, size_t bytes, void *function, void *argument)
{
    struct with_argument w = {function, argument};
    sort(base, count, bytes, compare_for_qsort_r, &w);
}

void *node_bsearch(const void *key, const void *base, size_t count, size_t bytes, void *function);
void *node_bsearch(const void *key, const void *base, size_t count, size_t bytes, void *function)
{
    size_t low = 0, end = count;
    while (low < end) {
        size_t middle = (low + end) / 2;
        char *at = (char *)base + middle * bytes;
        int order = compare(function, key, at);
        if (order == 0)
            return at;
        if (order < 0)
            end = middle;
        else
            low = middle + 1;
    }
    return NULL;
}

void *node_lfind(const void *key, const void *base, size_t *count, size_t bytes, void *function);
void *node_lfind(const void *key, const void *base, size_t *count, size_t bytes, void *function)
{
    char *at = (char *)base;
    for (size_t i = 0; i < *count; i++, at += bytes)
        if (compare(function, key, at) == 0)
            return at;
    return NULL;
}

void *node_lsearch(const void *key, void *base, size_t *count, size_t bytes, void *function);
void *node_lsearch(const void *key, void *base, size_t *count, size_t bytes, void *function)
{
    void *found = node_lfind(key, base, count, bytes, function);
    return found ? found : memcpy((char *)base + (*count)++ * bytes, key, bytes);
}
