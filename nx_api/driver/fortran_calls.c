/* fortran_calls.c - see fortran_calls.h. The records are those of nxcc/language/argument_counts.cc,
 * in section .nxc_calls. */
#include "nx_api/driver/fortran_calls.h"
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "nx_api/driver/elf_file.h"
#include "nx_api/driver/text.h"

/* Has the program a routine of its own by that name? */
static bool is_own(const char *records, const char *name)
{
    char *definition = text("d %s\n", name);
    const char *at = strstr(records, definition);
    while (at && at > records && at[-1] != '\n')
        at = strstr(at + 1, definition);
    free(definition);
    return at != NULL;
}

/* Reports the call of a line. False: the line is of another kind, or the call is right. */
static bool report(const char *records, const char *line)
{
    char name[64];
    int takes, gives, place = 0;
    if (sscanf(line, "c %63s %d %d %n", name, &takes, &gives, &place) < 3 || !place || is_own(records, name))
        return false;
    fprintf(stderr, "%s: %s takes %d argument%s, here %s %d: %.*s\n", program_invocation_short_name, name,
            takes, takes == 1 ? "" : "s", gives == 1 ? "is" : "are", gives, (int)strcspn(line + place, "\n"),
            line + place);
    return true;
}

void fortran_calls_check(const char *program)
{
    size_t size;
    int wrong = 0;
    struct elf_file f = elf_read(program);
    const char *section = elf_section(&f, ".nxc_calls", &size);
    char *records = section ? text("%.*s", (int)size, section) : NULL;
    for (const char *line = records; line && *line; line += strcspn(line, "\n") + 1)
        wrong += report(records, line);
    free(records);
    elf_forget(&f);
    if (!wrong)
        return;
    unlink(program);
    exit(1);
}
