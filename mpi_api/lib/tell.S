/* tell.S - tells of a call before it begins and after it ends, if somebody listens (mpi_api/core/told.h): the
 * way from a program's MPI_NAME to PMPI_NAME. CALL of lib.h makes the names, each of which comes here with its
 * text in %rax and PMPI_NAME in %r11.
 *
 * It is not compiled by nxcc, so that it takes no virtual time. The frame is what struct nxm_told describes:
 *
 *     -64  the first six arguments          0  the frame before
 *     -16  the text                         8  the place in the program
 *      -8  PMPI_NAME, then the answer      16  the other arguments
 */
        .text
        .globl  nxm_tell
        .hidden nxm_tell
        .type   nxm_tell, @function
nxm_tell:
        .cfi_startproc
        pushq   %rbp
        .cfi_def_cfa_offset 16
        .cfi_offset %rbp, -16
        movq    %rsp, %rbp
        .cfi_def_cfa_register %rbp
        pushq   %r11
        pushq   %rax
        pushq   %r9
        pushq   %r8
        pushq   %rcx
        pushq   %rdx
        pushq   %rsi
        pushq   %rdi
        movq    %rsp, %rdi
        leaq    nxm_library(%rip), %rsi
        call    nxm_begins@PLT
        movq    -64(%rbp), %rdi
        movq    -56(%rbp), %rsi
        movq    -48(%rbp), %rdx
        movq    -40(%rbp), %rcx
        movq    -32(%rbp), %r8
        movq    -24(%rbp), %r9
        .set    at, 72 /* no call has more than 14 arguments */
        .rept   8
        pushq   at(%rbp)
        .set    at, at - 8
        .endr
        call    *-8(%rbp)
        movslq  %eax, %rax
        movq    %rax, -8(%rbp)
        leaq    -64(%rbp), %rdi
        leaq    nxm_library(%rip), %rsi
        call    nxm_ends@PLT
        movq    -8(%rbp), %rax
        leave
        .cfi_def_cfa %rsp, 8
        ret
        .cfi_endproc
        .size   nxm_tell, .-nxm_tell
        .section .note.GNU-stack, "", @progbits
