/* elf_file.h - a linked program, in memory. */
#ifndef DRIVER_ELF_FILE_H
#define DRIVER_ELF_FILE_H
#include <elf.h>
#include <stddef.h>

struct elf_file {
    char *bytes; /* NULL: there is no such file, or it is no ELF file */
    size_t size;
};

struct elf_file elf_read(const char *path);
void elf_forget(struct elf_file *f);
/* A section's bytes, and how many; NULL: it is not there, or empty. */
char *elf_section(const struct elf_file *f, const char *name, size_t *size);
/* The symbols that a program has for others, or from them: count is 0 if there are none, or no ELF file. */
struct elf_dynamic {
    const Elf64_Sym *symbols;
    size_t count;
    const char *names; /* symbols' st_name begins there */
};
struct elf_dynamic elf_dynamic_of(const struct elf_file *f);
/* A section's lines, and how many, but for empty ones: an array to be freed, of lines in the file. */
char **elf_lines(const struct elf_file *f, const char *section, size_t *count);

#endif
