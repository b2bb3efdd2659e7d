/* enter.h - the beginning and the end of routines to which inline assembly of the program goes, and which
 * save what a C function may change: nxc_enter, to which a poll that strikes goes (runtime.c,
 * nx_api/mpi/tick.c), and those of race_runtime.c.
 *
 * The inline assembly has saved nothing. Between the beginning and the end, %rsp may be lowered and aligned
 * freely.
 */
#ifndef NXCC_ENTER_H
#define NXCC_ENTER_H

/* The call of nxc_enter in a program for simulated nodes (percent signs as in GCC's extended assembly),
 * which changes the x87 registers. Nothing may be written below the stack pointer, where the program may
 * look. So the call is made with the pointer in memory of runtime.c; the simulator returns with the
 * program's. */
#define NXC_CALL_ENTER                                                                                       \
    "movq\t%%rsp, nxc_stack_pointer(%%rip)\n"                                                                \
    "\tleaq\tnxc_stack_pointer(%%rip), %%rsp\n"                                                              \
    "\tcall\tnxc_enter"

#define NXC_BEGIN_ROUTINE(name)                                                                              \
    ".globl " name "\n"                                                                                      \
    ".type " name ", @function\n" name ":\n"                                                                 \
    "    .cfi_startproc\n"                                                                                   \
    "    pushq %rbp\n"                                                                                       \
    "    .cfi_def_cfa_offset 16\n"                                                                           \
    "    .cfi_offset %rbp, -16\n"                                                                            \
    "    movq %rsp, %rbp\n"                                                                                  \
    "    .cfi_def_cfa_register %rbp\n"

/* Saves the general registers behind %rax and %rcx, which have been pushed. */
#define NXC_PUSH_REGISTERS                                                                                   \
    "    pushq %rdx\n"                                                                                       \
    "    pushq %rsi\n"                                                                                       \
    "    pushq %rdi\n"                                                                                       \
    "    pushq %r8\n"                                                                                        \
    "    pushq %r9\n"                                                                                        \
    "    pushq %r10\n"                                                                                       \
    "    pushq %r11\n"

/* Restores all of them, and returns. */
#define NXC_END_ROUTINE(name)                                                                                \
    "    leaq -72(%rbp), %rsp\n"                                                                             \
    "    popq %r11\n"                                                                                        \
    "    popq %r10\n"                                                                                        \
    "    popq %r9\n"                                                                                         \
    "    popq %r8\n"                                                                                         \
    "    popq %rdi\n"                                                                                        \
    "    popq %rsi\n"                                                                                        \
    "    popq %rdx\n"                                                                                        \
    "    popq %rcx\n"                                                                                        \
    "    popq %rax\n"                                                                                        \
    "    popq %rbp\n"                                                                                        \
    "    .cfi_def_cfa %rsp, 8\n"                                                                             \
    "    ret\n"                                                                                              \
    "    .cfi_endproc\n"                                                                                     \
    ".size " name ", .-" name "\n"

/* Begins a routine to which nothing has been saved. */
#define NXC_BEGIN_SAVING(name)                                                                               \
    NXC_BEGIN_ROUTINE(name)                                                                                  \
    "    pushq %rax\n"                                                                                       \
    "    pushq %rcx\n" NXC_PUSH_REGISTERS

/* Of the SSE registers, in 256 bytes at %rsp, which is aligned to 16. */
#define NXC_SSE(f) f(0) f(1) f(2) f(3) f(4) f(5) f(6) f(7) f(8) f(9) f(10) f(11) f(12) f(13) f(14) f(15)
#define NXC_SAVE_ONE(n) "    movaps %xmm" #n ", 16*" #n "(%rsp)\n"
#define NXC_RESTORE_ONE(n) "    movaps 16*" #n "(%rsp), %xmm" #n "\n"
#define NXC_SAVE_SSE NXC_SSE(NXC_SAVE_ONE)
#define NXC_RESTORE_SSE NXC_SSE(NXC_RESTORE_ONE)
#endif
