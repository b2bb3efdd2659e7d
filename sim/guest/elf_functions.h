/* elf_functions.h - which function an address of a program belongs to, by the program's symbols. Knows
 * nothing of nodes. */
#ifndef GUEST_ELF_FUNCTIONS_H
#define GUEST_ELF_FUNCTIONS_H
#include "guest/elffile.h"

/* The function whose code contains vaddr, with its name, which lives as long as the file; NULL if none is
 * known. Names of C++ are as in the source, without parameters: "heat::step"; those of Fortran, too: "step".
 * Any thread may ask. */
const Elf64_Sym *elf_function_at(const struct elf_file *f, uint64_t vaddr, const char **name);
/* The file is closed. */
void elf_functions_free(struct elf_functions *all);
#endif
