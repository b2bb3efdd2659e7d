/* common_blocks.c - see common_blocks.h. The records are those of nxcc/language/common_sizes.cc, in section
 * .nxc_commons. */
#include "nx_api/driver/common_blocks.h"
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx_api/driver/elf_file.h"
#include "nx_api/driver/text.h"

struct block {
    char language; /* 'f', 'c' */
    const char *name;
    size_t bytes;
    const char *place; /* "blocks.f:3" */
};

/* Cuts a line up. */
static struct block block_of(char *line)
{
    struct block b = {.language = *line, .name = line + 2};
    char *bytes = strchr(b.name, ' ');
    if (!bytes)
        fail("a damaged record of COMMON blocks: %s", line);
    *bytes++ = '\0';
    b.bytes = strtoull(bytes, &bytes, 10);
    b.place = bytes + 1;
    return b;
}

/* By name; of one name, in the order in which the files were linked. */
static int compare(const void *left, const void *right)
{
    const struct block *a = left, *b = right;
    int order = strcmp(a->name, b->name);
    return order ? order : (a->place > b->place) - (a->place < b->place);
}

static struct block *read_blocks(const struct elf_file *f, size_t *count)
{
    char **lines = elf_lines(f, ".nxc_commons", count);
    struct block *list = calloc(*count + 1, sizeof *list);
    if (!list)
        fail("out of memory");
    for (size_t i = 0; i < *count; i++)
        list[i] = block_of(lines[i]);
    qsort(list, *count, sizeof *list, compare);
    free(lines);
    return list;
}

/* Does one of the blocks before the k-th have its size? */
static bool size_is_known(const struct block *list, size_t k)
{
    for (size_t i = 0; i < k; i++)
        if (list[i].bytes == list[k].bytes)
            return true;
    return false;
}

/* (GNU Fortran adds a _ to names.) */
static void print_name(const struct block *b)
{
    size_t length = strlen(b->name);
    if (b->language == 'f' && b->name[length - 1] == '_')
        length--;
    fprintf(stderr, "%s: warning: files disagree about the size of %s%.*s%s: %zu bytes at %s",
            program_invocation_short_name, b->language == 'f' ? "COMMON /" : "", (int)length, b->name,
            b->language == 'f' ? "/" : "", b->bytes, b->place);
}

/* Of so many blocks with one name. */
static void report(const struct block *list, size_t count)
{
    bool several = false;
    for (size_t i = 1; i < count; i++) {
        if (size_is_known(list, i))
            continue;
        if (!several)
            print_name(&list[0]);
        several = true;
        fprintf(stderr, ", %zu at %s", list[i].bytes, list[i].place);
    }
    if (several)
        fputc('\n', stderr);
}

void common_blocks_check(const char *program)
{
    struct elf_file f = elf_read(program);
    size_t count;
    struct block *list = read_blocks(&f, &count);
    for (size_t i = 0, same; i < count; i += same) {
        for (same = 1; i + same < count && !strcmp(list[i + same].name, list[i].name);)
            same++;
        report(list + i, same);
    }
    free(list);
    elf_forget(&f);
}
