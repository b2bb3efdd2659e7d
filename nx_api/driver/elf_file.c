/* elf_file.c - see elf_file.h. The linker has just written the file, and well: not everything is checked. */
#include "nx_api/driver/elf_file.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx_api/driver/text.h"

struct elf_file elf_read(const char *path)
{
    struct elf_file e = {NULL, 0};
    FILE *f = fopen(path, "r");
    if (!f)
        return e;
    if (!fseek(f, 0, SEEK_END) && (e.size = (size_t)ftell(f)) >= sizeof(Elf64_Ehdr) &&
        (e.bytes = malloc(e.size))) {
        rewind(f);
        if (fread(e.bytes, 1, e.size, f) != e.size)
            fail("%s: it cannot be read", path);
    }
    fclose(f);
    const Elf64_Ehdr *head = (const Elf64_Ehdr *)e.bytes;
    if (e.bytes && (memcmp(e.bytes, ELFMAG, SELFMAG) || !head->e_shoff || head->e_shoff > e.size))
        elf_forget(&e);
    return e;
}

void elf_forget(struct elf_file *f)
{
    free(f->bytes);
    f->bytes = NULL;
}

char *elf_section(const struct elf_file *f, const char *name, size_t *size)
{
    const Elf64_Ehdr *head = (const Elf64_Ehdr *)f->bytes;
    if (!head)
        return NULL;
    const Elf64_Shdr *sections = (const Elf64_Shdr *)(f->bytes + head->e_shoff);
    const char *names = f->bytes + sections[head->e_shstrndx].sh_offset;
    for (size_t i = 0; i < head->e_shnum; i++)
        if (!strcmp(names + sections[i].sh_name, name) && sections[i].sh_size > 0) {
            *size = sections[i].sh_size;
            return f->bytes + sections[i].sh_offset;
        }
    return NULL;
}

struct elf_dynamic elf_dynamic_of(const struct elf_file *f)
{
    size_t bytes = 0, names = 0;
    struct elf_dynamic d = {.symbols = (const Elf64_Sym *)elf_section(f, ".dynsym", &bytes),
                            .names = elf_section(f, ".dynstr", &names)};
    d.count = d.symbols && d.names ? bytes / sizeof *d.symbols : 0;
    return d;
}

char **elf_lines(const struct elf_file *f, const char *section, size_t *count)
{
    size_t size;
    char **lines = NULL, *text = elf_section(f, section, &size);
    *count = 0;
    if (text)
        text[size - 1] = '\0';
    for (char *line; (line = strsep(&text, "\n"));) {
        if (!*line)
            continue;
        lines = reallocarray(lines, *count + 1, sizeof *lines);
        if (!lines)
            fail("out of memory");
        lines[(*count)++] = line;
    }
    return lines;
}
