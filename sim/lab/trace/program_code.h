/* program_code.h - where a program's instructions lead: its jumps, calls and returns, as binutils' objdump
 * lists them. */
#ifndef LAB_TRACE_PROGRAM_CODE_H
#define LAB_TRACE_PROGRAM_CODE_H
#include <stddef.h>
#include <stdint.h>

/* A branch goes on at its target or behind it; a jump at its target; a call behind it; an end (a return, a
 * trap) nowhere. */
enum code_kind { CODE_BRANCH, CODE_JUMP, CODE_CALL, CODE_END };
struct code_point {
    uint64_t at, next; /* the instruction's address, and that behind it */
    uint64_t target;   /* CODE_NOWHERE: a register or memory tells it */
    enum code_kind kind;
};
#define CODE_NOWHERE UINT64_MAX

struct program_code {
    struct code_point *points; /* by address */
    size_t count;
};

/* The code of an ELF file; without points if objdump cannot be run, or does not know the file. The caller
 * frees it by program_code_free(). */
struct program_code *program_code_read(const char *path);
void program_code_free(struct program_code *c);
/* The first point at the address or behind it; count: there is none. */
size_t program_code_find(const struct program_code *c, uint64_t address);
#endif
