/* elffile.c - reads and checks an ELF executable: see elffile.h. */
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>
#include "kernel/xalloc.h"
#include "guest/elf_functions.h"
#include "guest/elffile.h"
#include "nx_api/contract/costs_mark.h"

bool elf_fail(char **error, const char *fmt, ...)
{
    va_list ap;
    va_start(ap, fmt);
    *error = xvasprintf(fmt, ap);
    va_end(ap);
    return false;
}

static bool truncated(const struct elf_file *f, char **error)
{
    return elf_fail(error, "%s: the file is truncated: build it again", f->path);
}

/* An array of count items of size bytes at offset; NULL unless all of the array is in the file, and
 * aligned. */
static const void *table_at(const struct elf_file *f, uint64_t offset, uint64_t count, uint64_t size)
{
    if (offset % 8 != 0 || offset > f->size || count > (f->size - offset) / size)
        return NULL;
    return f->bytes + offset;
}

static bool read_bytes(struct elf_file *f, char **error)
{
    struct stat st;
    f->fd = open(f->path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (f->fd < 0 || fstat(f->fd, &st) != 0)
        return elf_fail(error, "%s: %s", f->path, strerror(errno));
    if (!S_ISREG(st.st_mode))
        return elf_fail(error, "%s: not a regular file", f->path);
    size_t size = (size_t)st.st_size;
    f->bytes = malloc(size + 1);
    if (f->bytes == NULL)
        return elf_fail(error, "%s: %s", f->path, strerror(ENOMEM));
    while (f->size < size) {
        ssize_t got = read(f->fd, f->bytes + f->size, size - f->size);
        if (got < 0)
            return elf_fail(error, "%s: %s", f->path, strerror(errno));
        if (got == 0)
            break;
        f->size += (size_t)got;
    }
    return true;
}

static bool check_head(const struct elf_file *f, char **error)
{
    const Elf64_Ehdr *h = (const Elf64_Ehdr *)f->bytes;
    if (f->size < SELFMAG || memcmp(f->bytes, ELFMAG, SELFMAG) != 0)
        return elf_fail(error, "%s: not a program (no ELF header); %s", f->path, ELF_NOT_NXCC);
    if (f->size < sizeof *h)
        return truncated(f, error);
    if (h->e_ident[EI_CLASS] != ELFCLASS64 || h->e_ident[EI_DATA] != ELFDATA2LSB || h->e_machine != EM_X86_64)
        return elf_fail(error, "%s: built for another processor, not for x86-64", f->path);
    if (h->e_type == ET_REL)
        return elf_fail(error, "%s: an object file, not yet linked: link it with nxcc -o PROGRAM %s", f->path,
                        f->path);
    if (h->e_type != ET_DYN)
        return elf_fail(error, "%s: %s", f->path, ELF_NOT_NXCC);
    return true;
}

/* Collects the PT_LOAD entries, and refuses a file that the loader cannot load. */
static bool find_loads(struct elf_file *f, char **error)
{
    const Elf64_Ehdr *h = (const Elf64_Ehdr *)f->bytes;
    const Elf64_Phdr *ph = table_at(f, h->e_phoff, h->e_phnum, sizeof *ph);
    if (ph == NULL || h->e_phentsize != sizeof *ph)
        return truncated(f, error);
    Elf64_Phdr *loads = xcalloc(h->e_phnum + 1u, sizeof *loads);
    f->loads = loads;
    uint64_t end = 0;
    for (size_t i = 0; i < h->e_phnum; i++) {
        f->thread_locals |= ph[i].p_type == PT_TLS;
        f->runs_stack |= ph[i].p_type == PT_GNU_STACK && ph[i].p_flags & PF_X;
        if (ph[i].p_type != PT_LOAD || ph[i].p_memsz == 0)
            continue;
        if (ph[i].p_offset > f->size || ph[i].p_filesz > f->size - ph[i].p_offset)
            return truncated(f, error);
        if (ph[i].p_vaddr < end || ph[i].p_filesz > ph[i].p_memsz || ph[i].p_memsz > (UINT64_C(1) << 40) ||
            ph[i].p_vaddr > (UINT64_C(1) << 40) || (ph[i].p_vaddr - ph[i].p_offset) % 4096 != 0)
            return elf_fail(error, "%s: damaged program headers: build it again", f->path);
        end = ph[i].p_vaddr + ph[i].p_memsz;
        loads[f->load_count++] = ph[i];
    }
    if (f->load_count == 0)
        return elf_fail(error, "%s: %s", f->path, ELF_NOT_NXCC);
    return true;
}

static bool symbols_of(const struct elf_file *f, const Elf64_Shdr *sections, size_t count,
                       const Elf64_Shdr *s, struct elf_symbols *out)
{
    if (s->sh_link >= count)
        return false;
    const Elf64_Shdr *names = &sections[s->sh_link];
    out->count = s->sh_size / sizeof(Elf64_Sym);
    out->sym = table_at(f, s->sh_offset, out->count, sizeof(Elf64_Sym));
    out->names = (const char *)f->bytes + names->sh_offset;
    out->names_size = names->sh_size;
    return out->sym != NULL && names->sh_size > 0 && names->sh_offset <= f->size &&
           names->sh_size <= f->size - names->sh_offset && out->names[names->sh_size - 1] == 0;
}

static bool is_named(const struct elf_file *f, const Elf64_Shdr *names, const Elf64_Shdr *section,
                     const char *name)
{
    uint64_t at = names->sh_offset + section->sh_name;
    return at < f->size && f->size - at > strlen(name) && strcmp((const char *)f->bytes + at, name) == 0;
}

static bool find_symbols(struct elf_file *f, char **error)
{
    const Elf64_Ehdr *h = (const Elf64_Ehdr *)f->bytes;
    const Elf64_Shdr *s = table_at(f, h->e_shoff, h->e_shnum, sizeof *s);
    if (s == NULL)
        return truncated(f, error);
    if (h->e_shstrndx >= h->e_shnum)
        return elf_fail(error, "%s: has no section headers: do not strip them", f->path);
    const Elf64_Shdr *names = &s[h->e_shstrndx];
    for (size_t i = 0; i < h->e_shnum; i++) {
        if (s[i].sh_type == SHT_DYNSYM && !symbols_of(f, s, h->e_shnum, &s[i], &f->dynamic))
            return truncated(f, error);
        if (s[i].sh_type == SHT_SYMTAB && !symbols_of(f, s, h->e_shnum, &s[i], &f->all))
            return truncated(f, error);
        f->debug |= is_named(f, names, &s[i], ".debug_line");
        if (is_named(f, names, &s[i], NXC_COSTS_SECTION) && s[i].sh_offset <= f->size &&
            s[i].sh_size <= f->size - s[i].sh_offset) {
            f->costs = (const char *)f->bytes + s[i].sh_offset;
            f->costs_size = s[i].sh_size;
        }
    }
    if (f->dynamic.count == 0)
        return elf_fail(error, "%s: %s", f->path, ELF_NOT_NXCC);
    return true;
}

static bool relocations_of(const struct elf_file *f, uint64_t vaddr, uint64_t bytes,
                           struct elf_relocations *out)
{
    if (bytes == 0)
        return true;
    out->count = bytes / sizeof(Elf64_Rela);
    out->rela = elf_at(f, vaddr, bytes);
    return out->rela != NULL && (uintptr_t)out->rela % 8 == 0;
}

static bool find_relocations(struct elf_file *f, char **error)
{
    const Elf64_Ehdr *h = (const Elf64_Ehdr *)f->bytes;
    const Elf64_Phdr *ph = (const Elf64_Phdr *)(f->bytes + h->e_phoff);
    uint64_t value[DT_RELRSZ + 1] = {0};
    for (size_t i = 0; i < h->e_phnum; i++) {
        if (ph[i].p_type != PT_DYNAMIC)
            continue;
        const Elf64_Dyn *d = table_at(f, ph[i].p_offset, ph[i].p_filesz / sizeof *d, sizeof *d);
        if (d == NULL)
            return truncated(f, error);
        f->dynamic_at = ph[i].p_vaddr;
        for (size_t k = 0; k < ph[i].p_filesz / sizeof *d && d[k].d_tag != DT_NULL; k++)
            if (d[k].d_tag > 0 && d[k].d_tag <= DT_RELRSZ)
                value[d[k].d_tag] = d[k].d_un.d_val;
    }
    if (value[DT_RELRSZ] != 0)
        return elf_fail(
            error, "%s: linked with packed relocations (-z pack-relative-relocs): link it without", f->path);
    if (!relocations_of(f, value[DT_RELA], value[DT_RELASZ], &f->data) ||
        !relocations_of(f, value[DT_JMPREL], value[DT_PLTRELSZ], &f->calls))
        return elf_fail(error, "%s: damaged relocations: build it again", f->path);
    return true;
}

struct elf_file *elf_open(const char *path, char **error)
{
    struct elf_file *f = xcalloc(1, sizeof *f);
    f->fd = -1;
    f->path = xstrdup(path);
    if (read_bytes(f, error) && check_head(f, error) && find_loads(f, error) && find_symbols(f, error) &&
        find_relocations(f, error))
        return f;
    elf_close(f);
    return NULL;
}

void elf_close(struct elf_file *f)
{
    if (f == NULL)
        return;
    if (f->fd >= 0)
        close(f->fd);
    elf_functions_free(f->functions);
    free((void *)f->loads);
    free(f->bytes);
    free(f->path);
    free(f);
}

const void *elf_at(const struct elf_file *f, uint64_t vaddr, uint64_t bytes)
{
    for (size_t i = 0; i < f->load_count; i++) {
        const Elf64_Phdr *p = &f->loads[i];
        if (vaddr >= p->p_vaddr && vaddr - p->p_vaddr <= p->p_filesz &&
            bytes <= p->p_filesz - (vaddr - p->p_vaddr))
            return f->bytes + p->p_offset + (vaddr - p->p_vaddr);
    }
    return NULL;
}

const char *elf_name(const struct elf_symbols *t, const Elf64_Sym *s)
{
    return s->st_name < t->names_size ? t->names + s->st_name : "";
}

uint32_t elf_loaded_sum(const struct elf_file *f)
{
    uLong sum = crc32(0, NULL, 0);
    for (size_t i = 0; i < f->load_count; i++)
        if (f->loads[i].p_offset != 0)
            sum = crc32_z(sum, f->bytes + f->loads[i].p_offset, f->loads[i].p_filesz);
    return (uint32_t)sum;
}

const Elf64_Sym *elf_defined(const struct elf_symbols *t, const char *name)
{
    for (size_t i = 1; i < t->count; i++)
        if (t->sym[i].st_shndx != SHN_UNDEF && strcmp(elf_name(t, &t->sym[i]), name) == 0)
            return &t->sym[i];
    return NULL;
}
