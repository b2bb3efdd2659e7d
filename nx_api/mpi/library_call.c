/* library_call.c - see library_call.h. A program calls by a table, whose entries the dynamic linker has filled
 * in: the entry that the call's instructions name has a relocation, and that has the function's name. (What a
 * library calls its code for itself is of no use: its strlen is one of several, with local names.) */
#include "nx_api/mpi/library_call.h"
#include <link.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

/* --- instructions --- */

enum { CALL = 0xe8, GROUP = 0xff, CALL_BY_TABLE = 0x15, JUMP_BY_TABLE = 0x25 };

/* The address that 4 bytes name, by their distance from it. */
static const uint8_t *target(const uint8_t *distance)
{
    int32_t d;
    memcpy(&d, distance, sizeof d);
    return distance + sizeof d + d;
}

/* The linker's code for a function: it only jumps by the table. */
static const void *entry_of_stub(const uint8_t *code)
{
    static const uint8_t endbr64[] = {0xf3, 0x0f, 0x1e, 0xfa};
    if (memcmp(code, endbr64, sizeof endbr64) == 0)
        code += sizeof endbr64;
    code += *code == 0xf2; /* bnd */
    return code[0] == GROUP && code[1] == JUMP_BY_TABLE ? target(code + 2) : NULL;
}

extern const char __executable_start[], etext[]; /* the linker's: the bounds of the program's code */

static bool is_code(const uint8_t *code)
{
    return (const char *)code >= __executable_start && (const char *)code + 16 < etext;
}

static const void *entry_of_call(const uint8_t *behind)
{
    if (behind[-6] == GROUP && behind[-5] == CALL_BY_TABLE)
        return target(behind - 4);
    const uint8_t *to = behind[-5] == CALL ? target(behind - 4) : NULL;
    return to && is_code(to) ? entry_of_stub(to) : NULL;
}

/* --- relocations --- */

struct search {
    uintptr_t entry;
    const char *name;
};

static const char *name_of(const ElfW(Rela) * r, size_t bytes, uintptr_t offset, const ElfW(Sym) * symbols,
                           const char *names)
{
    for (size_t i = 0; i < bytes / sizeof *r; i++)
        if (r[i].r_offset == offset && ELF64_R_SYM(r[i].r_info))
            return names + symbols[ELF64_R_SYM(r[i].r_info)].st_name;
    return NULL;
}

static void search(struct search *s, uintptr_t bias, const ElfW(Dyn) * d)
{
    const ElfW(Rela) *plain = NULL, *calls = NULL;
    const ElfW(Sym) *symbols = NULL;
    const char *names = NULL;
    size_t plain_bytes = 0, call_bytes = 0;
    for (; d->d_tag != DT_NULL; d++) {
        const void *at = (const void *)d->d_un.d_ptr;
        switch (d->d_tag) {
        case DT_RELA:
            plain = at;
            break;
        case DT_RELASZ:
            plain_bytes = d->d_un.d_val;
            break;
        case DT_JMPREL:
            calls = at;
            break;
        case DT_PLTRELSZ:
            call_bytes = d->d_un.d_val;
            break;
        case DT_SYMTAB:
            symbols = at;
            break;
        case DT_STRTAB:
            names = at;
            break;
        }
    }
    if (!symbols || !names)
        return;
    s->name = name_of(calls, call_bytes, s->entry - bias, symbols, names);
    if (!s->name)
        s->name = name_of(plain, plain_bytes, s->entry - bias, symbols, names);
}

/* The first object is the program. */
static int search_program(struct dl_phdr_info *info, size_t size, void *what)
{
    (void)size;
    for (int i = 0; i < info->dlpi_phnum; i++)
        if (info->dlpi_phdr[i].p_type == PT_DYNAMIC)
            search(what, info->dlpi_addr, (const void *)(info->dlpi_addr + info->dlpi_phdr[i].p_vaddr));
    return 1;
}

const char *library_call_name(uintptr_t behind)
{
    struct search s = {(uintptr_t)entry_of_call((const uint8_t *)behind), NULL};
    if (s.entry)
        dl_iterate_phdr(search_program, &s);
    return s.name;
}
