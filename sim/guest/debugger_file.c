/* debugger_file.c - see debugger_file.h. */
#include "guest/debugger_file.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

/* The place in the copy of what lies in the file's bytes. */
static void *in_copy(const struct elf_file *f, unsigned char *copy, const void *in_file)
{
    return copy + ((const unsigned char *)in_file - f->bytes);
}

/* DT_DEBUG, which only a dynamic loader needs, makes room for DT_SYMBOLIC. */
static void make_symbolic(const struct elf_file *f, unsigned char *copy)
{
    const Elf64_Dyn *d = elf_at(f, f->dynamic_at, sizeof *d);
    while (d && d->d_tag != DT_NULL && d->d_tag != DT_DEBUG)
        d++;
    if (d && d->d_tag == DT_DEBUG)
        ((Elf64_Dyn *)in_copy(f, copy, d))->d_tag = DT_SYMBOLIC;
}

static void make_local(const struct elf_file *f, unsigned char *copy)
{
    for (size_t i = 0; i < f->all.count; i++) {
        const Elf64_Sym *s = &f->all.sym[i];
        if (ELF64_ST_TYPE(s->st_info) == STT_OBJECT)
            ((Elf64_Sym *)in_copy(f, copy, s))->st_info = ELF64_ST_INFO(STB_LOCAL, STT_OBJECT);
    }
}

bool debugger_file_write(const struct elf_file *f, const char *path)
{
    FILE *out = fopen(path, "wxe");
    if (!out)
        return false;
    unsigned char *copy = xmalloc(f->size);
    memcpy(copy, f->bytes, f->size);
    make_symbolic(f, copy);
    make_local(f, copy);
    bool good = fwrite(copy, 1, f->size, out) == f->size;
    free(copy);
    return fclose(out) == 0 && good;
}
