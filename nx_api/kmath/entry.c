/* entry.c - the entry point of one routine: NAME_ charges the program and jumps to the routine,
 * nx_kmath_NAME_, with all arguments as they were. Compiled once for each routine (-DNAME=dgemm -DNUMBER=...)
 * into an object of its own, so that a routine of the program's own replaces the entry point. */
#define TEXT_(s) #s
#define TEXT(s) TEXT_(s)

__asm__(
    "    .text\n"
    "    .globl " TEXT(
        NAME) "_\n"
              "    .type " TEXT(NAME) "_, @function\n" TEXT(
                  NAME) "_:\n"
                        "    pushq %rbp\n"
                        "    movq %rsp, %rbp\n"
                        "    pushq %r9\n"
                        "    pushq %r8\n"
                        "    pushq %rcx\n"
                        "    pushq %rdx\n"
                        "    pushq %rsi\n"
                        "    pushq %rdi\n"
                        "    movl $" TEXT(NUMBER) ", %edi\n"
                                                  "    movq %rsp, %rsi\n"
                                                  "    leaq 16(%rbp), %rdx\n"
                                                  "    call nx_kmath_pay\n"
                                                  "    popq %rdi\n"
                                                  "    popq %rsi\n"
                                                  "    popq %rdx\n"
                                                  "    popq %rcx\n"
                                                  "    popq %r8\n"
                                                  "    popq %r9\n"
                                                  "    popq %rbp\n"
                                                  "    jmp nx_kmath_" TEXT(
                                                      NAME) "_\n"
                                                            "    .size " TEXT(NAME) "_, .-" TEXT(NAME) "_\n");
