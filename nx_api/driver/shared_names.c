/* shared_names.c - see shared_names.h. */
#include "nx_api/driver/shared_names.h"
#include <elf.h>
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "nx_api/driver/elf_file.h"
#include "nx_api/driver/text.h"

struct dynamic {
    const Elf64_Sym *symbols;
    size_t count;
    const char *names;
};

/* None, if the file is none of ELF. */
static struct dynamic dynamic_of(const struct elf_file *f)
{
    size_t bytes = 0, names = 0;
    struct dynamic d = {.symbols = (const Elf64_Sym *)elf_section(f, ".dynsym", &bytes),
                        .names = elf_section(f, ".dynstr", &names)};
    d.count = d.symbols && d.names ? bytes / sizeof *d.symbols : 0;
    return d;
}

static bool has(const struct dynamic *d, const char *name)
{
    for (size_t i = 1; i < d->count; i++)
        if (d->symbols[i].st_shndx != SHN_UNDEF && !strcmp(d->names + d->symbols[i].st_name, name))
            return true;
    return false;
}

/* Appends a word to a list for people. */
static void list(char **all, const char *word)
{
    char *longer = *all ? text("%s, %s", *all, word) : text("%s", word);
    free(*all);
    *all = longer;
}

/* The names that the program has from neither its files nor `offered`; NULL: there are none. */
static char *foreign_names(const struct elf_file *program, const struct elf_file *offered)
{
    struct dynamic d = dynamic_of(program), o = dynamic_of(offered);
    char *all = NULL;
    for (size_t i = 1; i < d.count; i++) {
        const char *name = d.names + d.symbols[i].st_name;
        bool wanted = d.symbols[i].st_shndx == SHN_UNDEF && ELF64_ST_BIND(d.symbols[i].st_info) != STB_WEAK;
        if (wanted && !has(&o, name))
            list(&all, name);
    }
    return all;
}

/* (The linker notes those only that are needed: command.c.) */
static char *foreign_libraries(const struct elf_file *program, const char *offered)
{
    size_t bytes = 0, names = 0;
    const Elf64_Dyn *entry = (const Elf64_Dyn *)elf_section(program, ".dynamic", &bytes);
    const char *name = elf_section(program, ".dynstr", &names), *slash = strrchr(offered, '/');
    char *all = NULL;
    for (size_t i = 0; entry && name && i < bytes / sizeof *entry; i++)
        if (entry[i].d_tag == DT_NEEDED && strcmp(name + entry[i].d_un.d_val, slash ? slash + 1 : offered))
            list(&all, name + entry[i].d_un.d_val);
    return all;
}

void shared_names_check(const char *program, const char *offered)
{
    struct elf_file p = elf_read(program), o = elf_read(offered);
    char *names = foreign_names(&p, &o), *libraries = names ? foreign_libraries(&p, offered) : NULL;
    elf_forget(&p);
    elf_forget(&o);
    if (!names)
        return;
    unlink(program);
    fail("%s: in %s of this computer, but nodes load no libraries: link an archive (.a) of the sources that "
         "nxcc has compiled, or leave the library out",
         names, libraries ? libraries : "a library");
}
