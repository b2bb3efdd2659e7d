/* stubs.S - what programs linked by nxcc --stubs have for names that nodes do not: an entry of 16 bytes for each, up to 1024. The
 * loader (sim/node/image.c) deals them out. An entry tells the simulator its number, which answers for it
 * (sim/node/libc_absent.c).
 */
    .text
    .globl nxc_stubs
    .type nxc_stubs, @function
    .balign 16
nxc_stubs:
    .set number, 0
    .rept 1024
    .balign 16
    movl $number, %edi
    jmp nx_absent@PLT
    .set number, number + 1
    .endr
    .balign 16
    .size nxc_stubs, . - nxc_stubs
    .section .note.GNU-stack, "", @progbits
