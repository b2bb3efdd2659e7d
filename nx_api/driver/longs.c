/* longs.c - see longs.h. The records are those of nxcc/long_abi.cc: lines "BYTES FILE WHAT NAME" in section
 * .nxc_longs. */
#include "nx_api/driver/longs.h"
#include <elf.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "nx_api/driver/text.h"

struct record {
    const char *name, *file;
    char bytes, what;
};

/* --- the program's records --- */

/* The whole file, for free(); NULL if it cannot be read. */
static char *read_all(const char *path, size_t *size)
{
    char *all = NULL;
    FILE *f = fopen(path, "r");
    if (!f)
        return NULL;
    if (!fseek(f, 0, SEEK_END) && (*size = (size_t)ftell(f)) >= sizeof(Elf64_Ehdr) && (all = malloc(*size))) {
        rewind(f);
        if (fread(all, 1, *size, f) != *size)
            fail("%s: it cannot be read", path);
    }
    fclose(f);
    return all;
}

/* A section's bytes, ended by a 0 in place of its last, or NULL: the linker has just written the file, and
 * well. */
static char *section(char *elf, size_t size, const char *name)
{
    const Elf64_Ehdr *head = (const Elf64_Ehdr *)elf;
    const Elf64_Shdr *sections = (const Elf64_Shdr *)(elf + head->e_shoff);
    if (memcmp(elf, ELFMAG, SELFMAG) || !head->e_shoff || head->e_shoff > size)
        return NULL;
    const char *names = elf + sections[head->e_shstrndx].sh_offset;
    for (size_t i = 0; i < head->e_shnum; i++)
        if (!strcmp(names + sections[i].sh_name, name) && sections[i].sh_size > 0) {
            elf[sections[i].sh_offset + sections[i].sh_size - 1] = '\0';
            return elf + sections[i].sh_offset;
        }
    return NULL;
}

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

static size_t read_records(char *lines, struct record **list)
{
    size_t count = 0;
    for (char *line; (line = strsep(&lines, "\n"));) {
        if (!*line)
            continue;
        *list = reallocarray(*list, count + 1, sizeof **list);
        if (!*list)
            fail("out of memory");
        (*list)[count++] = record_of(line);
    }
    if (count)
        qsort(*list, count, sizeof **list, by_name);
    return count;
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
    size_t size;
    struct record *list = NULL;
    char *elf = read_all(program, &size), *lines = elf ? section(elf, size, ".nxc_longs") : NULL;
    size_t count = read_records(lines, &list);
    for (size_t i = 0; i < count; i++) {
        check_library(program, &list[i]);
        for (size_t k = i; k-- > 0 && !strcmp(list[k].name, list[i].name);) {
            check_pair(program, &list[i], &list[k]);
            check_pair(program, &list[k], &list[i]);
        }
    }
    free(list);
    free(elf);
}
