/* runtime.c - the part of a node program that nxcc adds: the counter, the program image's description, and
 * the routine that polls call. Compiled by plain gcc; see image.h.
 *
 * NXC_LONG_BYTES is the size of long in the program's C files. Files compiled with --long32 refer to a symbol
 * that is defined here only if the size is 4 (long32.cc), so that a program cannot be linked without
 * --long32.
 *
 * With NXC_HOSTED (tests) there is no _start, and the objects can be linked into an ordinary program.
 */
#include "enter.h"
#include "../contract/program_image.h"

/* In the initialised data: a node uses that page anyway. Behind the program's arrays they would cost a page
 * more. */
#define NXC_DATA __attribute__((visibility("hidden"), section(".data")))
NXC_DATA int64_t nxc_left;
NXC_DATA int64_t nxc_lookahead = NXC_NO_LOOKAHEAD;

extern int main(int argc, char **argv, char **envp);
extern void (*__init_array_start[])(void) __attribute__((visibility("hidden")));
extern void (*__init_array_end[])(void) __attribute__((visibility("hidden")));
/* The linker's symbols for the ends of section nxc_cells, if there is one. */
extern struct nxc_cell __start_nxc_cells[] __attribute__((visibility("hidden"), weak));
extern struct nxc_cell __stop_nxc_cells[] __attribute__((visibility("hidden"), weak));

#ifndef NXC_LONG_BYTES
#define NXC_LONG_BYTES 8
#endif
#if NXC_LONG_BYTES == 4
__attribute__((visibility("hidden"))) const char compiled_with_long32_so_link_with_long32;
#endif

struct nxc_image nxc_image = {
    .magic = NXC_IMAGE_MAGIC,
    .version = NXC_IMAGE_VERSION,
    .left = &nxc_left,
    .lookahead = &nxc_lookahead,
    .main = main,
    .init_begin = __init_array_start,
    .init_end = __init_array_end,
    .cells_begin = __start_nxc_cells,
    .cells_end = __stop_nxc_cells,
    .long_bytes = NXC_LONG_BYTES,
};

/* nxc_enter: the inline assembly of a poll that strikes calls it. The stack may have any alignment, and
 * nothing is saved but the x87 registers. So nxc_enter saves all else that a C function may change, and calls
 * nxc_preempt. The direction flag and the control words are as the ABI wants them. */
#define SSE(f) f(0) f(1) f(2) f(3) f(4) f(5) f(6) f(7) f(8) f(9) f(10) f(11) f(12) f(13) f(14) f(15)
#define SAVE_ONE(n) "    movaps %xmm" #n ", 16*" #n "(%rsp)\n"
#define RESTORE_ONE(n) "    movaps 16*" #n "(%rsp), %xmm" #n "\n"
#define SAVE_SSE SSE(SAVE_ONE)
#define RESTORE_SSE SSE(RESTORE_ONE)

__asm__(".text\n"
        ".hidden nxc_enter\n" NXC_ENTER_SAVE "    subq $264, %rsp\n"
        "    andq $-16, %rsp\n" SAVE_SSE "    stmxcsr 256(%rsp)\n"
        "    call nxc_preempt@PLT\n"
        "    ldmxcsr 256(%rsp)\n" RESTORE_SSE NXC_ENTER_RESTORE);

#ifndef NXC_HOSTED
/* Runs when somebody starts the program in a shell. Nothing has been relocated, so that the code may use only
 * what it addresses relative to the instruction pointer. */
__asm__(".text\n"
        ".globl _start\n"
        ".hidden _start\n"
        ".type _start, @function\n"
        "_start:\n"
        "    movl $1, %eax\n" /* write(2, text, length) */
        "    movl $2, %edi\n"
        "    leaq 1f(%rip), %rsi\n"
        "    movl $(2f - 1f), %edx\n"
        "    syscall\n"
        "    movl $231, %eax\n" /* exit_group(126) */
        "    movl $126, %edi\n"
        "    syscall\n"
        "    hlt\n"
        ".size _start, .-_start\n"
        ".section .rodata\n"
        "1:  .ascii \"this is a node program: run it with  touchstone run PROGRAM\\n\"\n"
        "2:\n"
        ".text\n");
#endif
