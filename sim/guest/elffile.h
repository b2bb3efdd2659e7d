/* elffile.h - an ELF executable as a checked array of bytes.
 *
 * elf_open() reads the whole file and makes sure that its tables lie inside it, so that the loader
 * (image.c) need not check them again. Only 64-bit x86-64 position-independent executables pass. Knows
 * nothing of nodes. */
#ifndef GUEST_ELFFILE_H
#define GUEST_ELFFILE_H
#include <elf.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct elf_symbols {
    const Elf64_Sym *sym;
    size_t count;
    const char *names; /* the last byte is 0 */
    size_t names_size;
};

struct elf_relocations {
    const Elf64_Rela *rela;
    size_t count;
};

struct elf_functions;

struct elf_file {
    char *path;
    int fd;
    unsigned char *bytes;
    size_t size;
    const Elf64_Phdr *loads; /* the PT_LOAD entries, by address; a copy */
    size_t load_count;
    struct elf_symbols dynamic;                /* .dynsym: what relocations refer to */
    struct elf_symbols all;                    /* .symtab; empty if stripped */
    struct elf_relocations data, calls;        /* DT_RELA, DT_JMPREL */
    uint64_t dynamic_at;                       /* the address of PT_DYNAMIC */
    bool debug;                                /* the file has line numbers */
    bool thread_locals;                        /* the file has a segment of thread-local variables */
    bool runs_stack;                           /* a nested function's address leads to code on the stack */
    const char *costs;                         /* lines of the section of costs_mark.h, */
    size_t costs_size;                         /* so many bytes */
    _Atomic(struct elf_functions *) functions; /* elf_functions.h; NULL: nobody has asked yet */
};

/* Returns NULL and sets *error (malloc'd; begins with the path) if the file cannot be read or is not such
 * an executable. The caller closes the file by elf_close(). */
struct elf_file *elf_open(const char *path, char **error);
void elf_close(struct elf_file *f);

/* The bytes [vaddr, vaddr + bytes) of the program as the file holds them; NULL unless the file holds them
 * all. */
const void *elf_at(const struct elf_file *f, uint64_t vaddr, uint64_t bytes);

/* Tells programs apart: a checksum of what is loaded, without the part that has the file's head, its notes
 * and symbols. The same for a program with and without debugging information. */
uint32_t elf_loaded_sum(const struct elf_file *f);

/* The name of a symbol; "" if it has none. */
const char *elf_name(const struct elf_symbols *t, const Elf64_Sym *s);
/* The defined symbol of a name; NULL if there is none. */
const Elf64_Sym *elf_defined(const struct elf_symbols *t, const char *name);

/* Sets *error to a malloc'd text and returns false. */
bool elf_fail(char **error, const char *fmt, ...) __attribute__((format(printf, 2, 3)));

#define ELF_NOT_NXCC "not built by nxcc: build it with nxcc -o PROGRAM FILE.c ..."
#endif
