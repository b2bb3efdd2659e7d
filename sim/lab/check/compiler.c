/* compiler.c - see compiler.h. GCC writes its version into the section .comment of each object, as
 * "GCC: (Debian 12.2.0-14) 12.2.0"; the linker keeps one copy of equal texts. */
#include "lab/check/compiler.h"
#include "kernel/xalloc.h"

#include <fcntl.h>
#include <gelf.h>
#include <string.h>
#include <unistd.h>

/* The section's first text; NULL if there is no such section. */
static const char *first_comment(Elf *elf)
{
    size_t names;
    GElf_Shdr header;
    if (elf_getshdrstrndx(elf, &names) != 0)
        return NULL;
    for (Elf_Scn *section = NULL; (section = elf_nextscn(elf, section));) {
        const char *name = gelf_getshdr(section, &header) ? elf_strptr(elf, names, header.sh_name) : NULL;
        if (!name || strcmp(name, ".comment") != 0)
            continue;
        const Elf_Data *data = elf_getdata(section, NULL);
        return data && data->d_size && memchr(data->d_buf, '\0', data->d_size) ? data->d_buf : NULL;
    }
    return NULL;
}

char *compiler_of(const char *program)
{
    static const char gcc[] = "GCC: (";
    elf_version(EV_CURRENT);
    int fd = open(program, O_RDONLY | O_CLOEXEC);
    Elf *elf = fd < 0 ? NULL : elf_begin(fd, ELF_C_READ, NULL);
    const char *comment = elf ? first_comment(elf) : NULL;
    const char *version = comment && !strncmp(comment, gcc, strlen(gcc)) ? strstr(comment, ") ") : NULL;
    char *compiler = version ? xasprintf("GCC %s", version + 2) : NULL;
    elf_end(elf);
    if (fd >= 0)
        close(fd);
    return compiler;
}
