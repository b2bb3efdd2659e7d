/* lines.c - see lines.h. */
#include "nx_api/mpi/lines.h"
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include "nx_api/mpi/addr2line.h"

struct place {
    uint64_t address;
    char *function, *line; /* NULL: not known */
};

struct lines {
    struct place *all; /* by address, each once */
    size_t count;
};

static void *must(void *p)
{
    if (!p)
        abort();
    return p;
}

/* --- the addresses --- */

static int compare(const void *a, const void *b)
{
    uint64_t x = ((const struct place *)a)->address, y = ((const struct place *)b)->address;
    return (x > y) - (x < y);
}

static void add_all(struct lines *l, const uint64_t *addresses, size_t count)
{
    l->all = must(calloc(count + 1, sizeof *l->all));
    for (size_t i = 0; i < count; i++)
        l->all[i].address = addresses[i];
    qsort(l->all, count, sizeof *l->all, compare);
    for (size_t i = 0; i < count; i++)
        if (l->all[i].address && (!l->count || l->all[l->count - 1].address != l->all[i].address))
            l->all[l->count++].address = l->all[i].address;
}

/* --- addr2line --- */

/* The line before an address behind a call: its instruction is the call. */
static const char **command(const struct lines *l)
{
    const char **argv = must(calloc(ADDR2LINE_BEFORE + l->count + 1, sizeof *argv));
    for (size_t i = 0; i < l->count; i++) {
        char *digits = must(malloc(ADDR2LINE_DIGITS));
        addr2line_digits(digits, l->all[i].address - 1);
        argv[ADDR2LINE_BEFORE + i] = digits;
    }
    return argv;
}

static void free_command(const char **argv)
{
    for (const char **a = argv + ADDR2LINE_BEFORE; *a; a++)
        free((char *)(uintptr_t)*a);
    free(argv);
}

static char *copy(const char *text)
{
    return text ? must(strdup(text)) : NULL;
}

static void read_answers(struct lines *l, FILE *f)
{
    char function[2000], line[PATH_MAX + 100];
    for (size_t i = 0; i < l->count; i++) {
        if (!fgets(function, sizeof function, f) || !fgets(line, sizeof line, f))
            return;
        const char *place = addr2line_place(line);
        l->all[i].function = copy(addr2line_function(function, place));
        l->all[i].line = copy(place);
    }
}

static void ask(struct lines *l)
{
    pid_t child;
    const char **argv = command(l);
    int from = addr2line_start(argv, &child);
    free_command(argv);
    FILE *f = from < 0 ? NULL : fdopen(from, "r");
    if (!f)
        return;
    read_answers(l, f);
    fclose(f);
    while (waitpid(child, NULL, 0) < 0 && errno == EINTR)
        ;
}

/* --- what is known --- */

struct lines *lines_find(const uint64_t *addresses, size_t count)
{
    struct lines *l = must(calloc(1, sizeof *l));
    add_all(l, addresses, count);
    if (l->count)
        ask(l);
    return l;
}

void lines_free(struct lines *l)
{
    for (size_t i = 0; i < l->count; i++) {
        free(l->all[i].function);
        free(l->all[i].line);
    }
    free(l->all);
    free(l);
}

static const struct place *find(const struct lines *l, uint64_t address)
{
    return bsearch(&(struct place){.address = address}, l->all, l->count, sizeof *l->all, compare);
}

const char *lines_at(const struct lines *l, uint64_t address)
{
    const struct place *p = find(l, address);
    return p ? p->line : NULL;
}

const char *lines_function(const struct lines *l, uint64_t address)
{
    const struct place *p = find(l, address);
    return p ? p->function : NULL;
}
