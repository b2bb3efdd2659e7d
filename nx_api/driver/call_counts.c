/* call_counts.c - see call_counts.h. The records are those of nxcc/language/argument_counts.cc,
 * in section .nxc_calls. */
#include "nx_api/driver/call_counts.h"
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "nx_api/driver/elf_file.h"
#include "nx_api/driver/text.h"

/* Has the program a function of its own by that name? */
static bool is_own(const char *records, char language, const char *name)
{
    char *definition = text("d%c %s\n", language, name);
    const char *at = strstr(records, definition);
    while (at && at > records && at[-1] != '\n')
        at = strstr(at + 1, definition);
    free(definition);
    return at != NULL;
}

/* A call that is wrong. */
struct call {
    char language, name[64]; /* 'f', 'c' */
    int takes, gives, file_length, line;
    const char *place; /* "few.f:4\n", in the records */
};

/* Is the call in a program that Autoconf or CMake links, and never runs, to see whether there is such a
 * function? These give no arguments. */
static bool only_asks(const struct call *c)
{
    static const char *const probes[] = {"conftest.", "testFortranCompiler."};
    const char *name = c->place;
    for (int i = 0; i < c->file_length; i++)
        if (c->place[i] == '/')
            name = c->place + i + 1;
    for (size_t i = 0; i < sizeof probes / sizeof *probes; i++)
        if (c->gives == 0 && strncmp(name, probes[i], strlen(probes[i])) == 0)
            return true;
    return false;
}

/* False: the record is of another kind, or the call is right. */
static bool is_wrong(const char *records, const char *record, struct call *c)
{
    int place = 0;
    if (sscanf(record, "%c %63s %d %d %n", &c->language, c->name, &c->takes, &c->gives, &place) < 4 ||
        !place || is_own(records, c->language, c->name))
        return false;
    c->place = record + place;
    c->file_length = (int)strcspn(c->place, ":\n");
    c->line = atoi(c->place + c->file_length + strspn(c->place + c->file_length, ":"));
    return !only_asks(c);
}

/* In the order of the source. */
static int compare(const void *left, const void *right)
{
    const struct call *a = left, *b = right;
    int shorter = a->file_length < b->file_length ? a->file_length : b->file_length;
    int order = strncmp(a->place, b->place, (size_t)shorter + 1);
    return order ? order : a->line != b->line ? a->line - b->line : strcmp(a->name, b->name);
}

/* Is it more than a warning? An argument too many the callee does not see, and MPI programs with such calls
 * have run everywhere. */
static bool is_error(const struct call *c)
{
    bool of_mpi = strncmp(c->name, "mpi_", 4) == 0 || strncmp(c->name, "pmpi_", 5) == 0;
    return c->language == 'f' && (c->gives < c->takes || !of_mpi);
}

static void report(const struct call *c)
{
    fprintf(stderr, "%s: %s%s takes %d argument%s, here %s %d: %.*s\n", program_invocation_short_name,
            is_error(c) ? "" : "warning: ", c->name, c->takes, c->takes == 1 ? "" : "s",
            c->gives == 1 ? "is" : "are", c->gives, (int)strcspn(c->place, "\n"), c->place);
}

void call_counts_check(const char *program)
{
    size_t size, wrong = 0, errors = 0;
    struct elf_file f = elf_read(program);
    const char *section = elf_section(&f, ".nxc_calls", &size);
    char *records = section ? text("%.*s", (int)size, section) : NULL;
    struct call *calls = NULL, one;
    for (const char *record = records; record && *record; record += strcspn(record, "\n") + 1)
        if (is_wrong(records, record, &one)) {
            calls = reallocarray(calls, wrong + 1, sizeof *calls);
            if (!calls)
                fail("out of memory");
            calls[wrong++] = one;
        }
    if (wrong)
        qsort(calls, wrong, sizeof *calls, compare);
    for (size_t i = 0; i < wrong; i++) {
        report(&calls[i]);
        errors += is_error(&calls[i]);
    }
    free(calls);
    free(records);
    elf_forget(&f);
    if (!errors)
        return;
    unlink(program);
    exit(1);
}
