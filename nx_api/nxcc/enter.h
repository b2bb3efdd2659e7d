/* enter.h - the beginning and the end of nxc_enter, the routine to which a poll that strikes goes (runtime.c,
 * nx_api/mpi/tick.c).
 *
 * A poll has saved nothing. These two save and restore the general registers that a C function may change.
 * Between the two, %rsp may be lowered and aligned freely.
 */
#ifndef NXCC_ENTER_H
#define NXCC_ENTER_H

#define NXC_ENTER_SAVE                                                                                       \
    ".globl nxc_enter\n"                                                                                     \
    ".type nxc_enter, @function\n"                                                                           \
    "nxc_enter:\n"                                                                                           \
    "    .cfi_startproc\n"                                                                                   \
    "    pushq %rbp\n"                                                                                       \
    "    .cfi_def_cfa_offset 16\n"                                                                           \
    "    .cfi_offset %rbp, -16\n"                                                                            \
    "    movq %rsp, %rbp\n"                                                                                  \
    "    .cfi_def_cfa_register %rbp\n"                                                                       \
    "    pushq %rax\n"                                                                                       \
    "    pushq %rcx\n"                                                                                       \
    "    pushq %rdx\n"                                                                                       \
    "    pushq %rsi\n"                                                                                       \
    "    pushq %rdi\n"                                                                                       \
    "    pushq %r8\n"                                                                                        \
    "    pushq %r9\n"                                                                                        \
    "    pushq %r10\n"                                                                                       \
    "    pushq %r11\n"

#define NXC_ENTER_RESTORE                                                                                    \
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
    ".size nxc_enter, .-nxc_enter\n"
#endif
