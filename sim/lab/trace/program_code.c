/* program_code.c - see program_code.h. */
#include "lab/trace/program_code.h"
#include <fcntl.h>
#include <spawn.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include "kernel/xalloc.h"

extern char **environ;

/* Runs objdump on the file; what it prints is to be read from *out. False: it cannot be run. */
static bool start(const char *path, pid_t *pid, FILE **out)
{
    char *const words[] = {"objdump", "-d", "-w", "--no-show-raw-insn", "--", (char *)path, NULL};
    int ends[2];
    posix_spawn_file_actions_t actions;
    if (pipe2(ends, O_CLOEXEC))
        return false;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    bool started = !posix_spawnp(pid, words[0], &actions, NULL, words, environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (started)
        *out = xchecked(fdopen(ends[0], "r"));
    else
        close(ends[0]);
    return started;
}

/* The word of an instruction that says what it does, behind its prefixes. */
static const char *operation(const char *text)
{
    static const char *const PREFIXES[] = {"bnd ", "notrack ", "repz ", "rep ", "data16 ", "cs ", "ds "};
    for (size_t i = 0; i < sizeof PREFIXES / sizeof *PREFIXES; i++)
        if (!strncmp(text, PREFIXES[i], strlen(PREFIXES[i])))
            return operation(text + strlen(PREFIXES[i]));
    return text;
}

/* Is the instruction one that leads elsewhere? Sets kind and target. */
static bool leads(const char *text, struct code_point *p)
{
    const char *word = operation(text);
    size_t length = strcspn(word, " \n");
    if (*word == 'j')
        p->kind = !strncmp(word, "jmp", 3) ? CODE_JUMP : CODE_BRANCH;
    else if (!strncmp(word, "call", 4))
        p->kind = CODE_CALL;
    else if (!strncmp(word, "ret", 3) || !strncmp(word, "ud2", 3) || !strncmp(word, "hlt", 3))
        p->kind = CODE_END;
    else
        return false;
    char *end;
    p->target = strtoull(word + length, &end, 16);
    if (p->kind == CODE_END || end == word + length ||
        strchr("*(%", word[length + strspn(word + length, " ")]))
        p->target = CODE_NOWHERE;
    return true;
}

/* Reads lines as "    52b1:\tcall   73f0 <csend_>"; other lines name sections and functions. */
static void read_lines(FILE *in, struct program_code *c)
{
    char *line = NULL, *end;
    size_t size = 0;
    bool open = false; /* the last point's `next` is not known yet */
    while (getline(&line, &size, in) > 0) {
        uint64_t at = strtoull(line, &end, 16);
        if (end == line || end[0] != ':' || end[1] != '\t')
            continue;
        if (open)
            c->points[c->count - 1].next = at;
        struct code_point p = {.at = at, .next = at};
        if (!(open = leads(end + 2, &p)))
            continue;
        c->points = xgrown(c->points, c->count, sizeof *c->points);
        c->points[c->count++] = p;
    }
    free(line);
}

struct program_code *program_code_read(const char *path)
{
    struct program_code *c = xcalloc(1, sizeof *c);
    pid_t pid;
    FILE *out;
    if (start(path, &pid, &out)) {
        read_lines(out, c);
        fclose(out);
        waitpid(pid, NULL, 0);
    }
    return c;
}

void program_code_free(struct program_code *c)
{
    if (!c)
        return;
    free(c->points);
    free(c);
}

size_t program_code_find(const struct program_code *c, uint64_t address)
{
    size_t low = 0, high = c->count;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (c->points[middle].at < address)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}
