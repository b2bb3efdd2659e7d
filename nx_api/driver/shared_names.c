/* shared_names.c - see shared_names.h. */
#include "nx_api/driver/shared_names.h"
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "nx_api/driver/elf_file.h"
#include "nx_api/driver/text.h"

static bool has(const struct elf_dynamic *d, const char *name)
{
    for (size_t i = 1; i < d->count; i++)
        if (d->symbols[i].st_shndx != SHN_UNDEF && !strcmp(d->names + d->symbols[i].st_name, name))
            return true;
    return false;
}

/* The names that the program has from neither its files nor `offered`; NULL: there are none. */
static char *foreign_names(const struct elf_file *program, const struct elf_file *offered)
{
    struct elf_dynamic d = elf_dynamic_of(program), o = elf_dynamic_of(offered);
    char *all = NULL;
    for (size_t i = 1; i < d.count; i++) {
        const char *name = d.names + d.symbols[i].st_name;
        bool wanted = d.symbols[i].st_shndx == SHN_UNDEF && ELF64_ST_BIND(d.symbols[i].st_info) != STB_WEAK;
        if (wanted && !has(&o, name))
            text_list(&all, name);
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
            text_list(&all, name + entry[i].d_un.d_val);
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
