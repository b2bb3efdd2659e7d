/* longs.c - see longs.h. The records are those of nxcc/language/long_abi.cc: lines "BYTES FILE WHAT NAME"
 * in section .nxc_longs. */
#include "nx_api/driver/longs.h"
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "nx_api/driver/elf_file.h"
#include "nx_api/driver/text.h"

struct record {
    const char *name, *file;
    char bytes, what;
};

/* --- the program's records --- */

/* Cuts a line up. A file's name may have blanks, what is behind it has none. */
static struct record record_of(char *line)
{
    char *name = strrchr(line, ' ');
    if (!name || name < line + 5)
        fail("a damaged record of longs: %s", line);
    name[-2] = '\0';
    return (struct record){.name = name + 1, .file = line + 2, .bytes = line[0], .what = name[-1]};
}

static int by_name(const void *a, const void *b)
{
    const struct record *x = a, *y = b;
    return strcmp(x->name, y->name);
}

static struct record *read_records(const struct elf_file *f, size_t *count)
{
    char **lines = elf_lines(f, ".nxc_longs", count);
    struct record *list = calloc(*count + 1, sizeof *list);
    if (!list)
        fail("out of memory");
    for (size_t i = 0; i < *count; i++)
        list[i] = record_of(lines[i]);
    qsort(list, *count, sizeof *list, by_name);
    free(lines);
    return list;
}

/* --- clashes --- */

/* Of two records of one function: do longs go from one to the other? */
static bool clash(const struct record *wide, const struct record *narrow)
{
    if (wide->bytes != '8' || narrow->bytes != '4' || strcmp(wide->name, narrow->name) != 0)
        return false;
    return narrow->what == 'd' ? wide->what == 'c' : wide->what == 'd' || wide->what == 'v';
}

static void check_library(const char *program, const struct record *r)
{
    if (r->bytes != '8' || r->what != 'l')
        return;
    unlink(program);
    fail("%s, compiled without --long32, hands longs to %s, which has longs of 4 bytes in a program "
         "linked with --long32: compile it with --long32, too",
         r->file, r->name);
}

static void check_pair(const char *program, const struct record *wide, const struct record *narrow)
{
    if (!clash(wide, narrow))
        return;
    unlink(program);
    fail("%s, compiled without --long32, and %s, compiled with it, hand longs to each other by %s: "
         "compile both with --long32, or neither",
         wide->file, narrow->file, wide->name);
}

void longs_check(const char *program)
{
    struct elf_file f = elf_read(program);
    size_t count;
    struct record *list = read_records(&f, &count);
    for (size_t i = 0; i < count; i++) {
        check_library(program, &list[i]);
        for (size_t k = i; k-- > 0 && !strcmp(list[k].name, list[i].name);) {
            check_pair(program, &list[i], &list[k]);
            check_pair(program, &list[k], &list[i]);
        }
    }
    free(list);
    elf_forget(&f);
}
