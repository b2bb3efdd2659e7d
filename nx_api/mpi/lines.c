/* lines.c - see lines.h. */
#include "nx_api/mpi/lines.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <spawn.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

struct place {
    uint64_t address;
    char *function, *line; /* NULL: not known */
};

struct lines {
    struct place *all; /* by address, each once */
    size_t count;
};

extern char **environ;

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
static char **command(const struct lines *l, char *program)
{
    enum { DIGITS = 20, OPTIONS = 4 };
    char **argv = must(calloc(OPTIONS + l->count + 1, sizeof *argv));
    argv[0] = must(strdup("addr2line"));
    argv[1] = must(strdup("-f"));
    argv[2] = must(strdup("-e"));
    argv[3] = must(strdup(program));
    for (size_t i = 0; i < l->count; i++) {
        argv[OPTIONS + i] = must(malloc(DIGITS));
        snprintf(argv[OPTIONS + i], DIGITS, "%llx", (unsigned long long)(l->all[i].address - 1));
    }
    return argv;
}

static void free_command(char **argv)
{
    for (char **a = argv; *a; a++)
        free(*a);
    free(argv);
}

/* Starts it: what it says comes from the descriptor returned; -1: there is no addr2line. */
static int start(char **argv, pid_t *child)
{
    int ends[2];
    posix_spawn_file_actions_t actions;
    if (pipe2(ends, O_CLOEXEC) != 0)
        return -1;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    int error = posix_spawnp(child, argv[0], &actions, NULL, argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (!error)
        return ends[0];
    close(ends[0]);
    return -1;
}

/* Without what compilers append to the names of a function's parts and copies (work.part.0). */
static char *function_name(char *text)
{
    text[strcspn(text, ".\n")] = '\0';
    return *text && strcmp(text, "??") != 0 ? must(strdup(text)) : NULL;
}

/* "/home/x/ring.c:17 (discriminator 2)" -> "ring.c:17" */
static char *line_name(char *text)
{
    text[strcspn(text, " \n")] = '\0';
    const char *slash = strrchr(text, '/'), *name = slash ? slash + 1 : text, *colon = strrchr(name, ':');
    bool known = colon && name[0] != '?' && colon[1] >= '1' && colon[1] <= '9';
    return known ? must(strdup(name)) : NULL;
}

static void read_answers(struct lines *l, FILE *f)
{
    char function[2000], line[PATH_MAX + 100];
    for (size_t i = 0; i < l->count; i++) {
        if (!fgets(function, sizeof function, f) || !fgets(line, sizeof line, f))
            return;
        l->all[i].function = function_name(function);
        l->all[i].line = line_name(line);
    }
}

static void ask(struct lines *l)
{
    char program[PATH_MAX + 1] = "";
    pid_t child;
    if (readlink("/proc/self/exe", program, PATH_MAX) <= 0)
        return;
    char **argv = command(l, program);
    int from = start(argv, &child);
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
