/* elffile.h - an ELF executable as a checked array of bytes.
 *
 * elf_open() reads the whole file and makes sure that its tables lie inside it, so that the loader (image.c)
 * can walk them without further doubt. Only 64-bit x86-64 position-independent executables pass. Knows
 * nothing of nodes.
 */
#ifndef NODE_ELFFILE_H
#define NODE_ELFFILE_H
#include <elf.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct elf_symbols {
    const Elf64_Sym *sym;
    size_t count;
    const char *names; /* ends with a 0 */
    size_t names_size;
};

struct elf_relocations {
    const Elf64_Rela *rela;
    size_t count;
};

struct elf_file {
    char *path;
    int fd;
    unsigned char *bytes;
    size_t size;
    const Elf64_Phdr *loads; /* PT_LOAD entries only, by address, in memory of our own */
    size_t load_count;
    struct elf_symbols dynamic;         /* .dynsym: what relocations refer to */
    struct elf_symbols all;             /* .symtab; empty when stripped */
    struct elf_relocations data, calls; /* DT_RELA, DT_JMPREL */
    bool debug;                         /* line numbers are there */
};

/* NULL with *error set (malloc'd, starts with the path) when it cannot be read or is not such a file. */
struct elf_file *elf_open(const char *path, char **error);
void elf_close(struct elf_file *f);

/* The bytes [vaddr, vaddr + bytes) of the program as the file holds them; NULL when it does not hold them
 * all. */
const void *elf_at(const struct elf_file *f, uint64_t vaddr, uint64_t bytes);

/* Name of a symbol; "" when it has none. */
const char *elf_name(const struct elf_symbols *t, const Elf64_Sym *s);
/* The defined symbol of that name, NULL when there is none. */
const Elf64_Sym *elf_defined(const struct elf_symbols *t, const char *name);
/* The function whose code contains vaddr, with its name; NULL when none is known. */
const Elf64_Sym *elf_function_at(const struct elf_file *f, uint64_t vaddr, const char **name);

/* Sets *error to a malloc'd text and returns false. */
bool elf_fail(char **error, const char *fmt, ...) __attribute__((format(printf, 2, 3)));

#define ELF_NOT_NXCC "not built by nxcc: build it with nxcc -o PROGRAM FILE.c ..."
#endif
