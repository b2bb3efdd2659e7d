/* switch.c - what was written in the i860's assembler: from one stack to another. Here for x86-64. */
char *thread_stack(top, entry)
char *top;
int (*entry)();
{
    long long *sp = (long long *)((long long)top & ~15);
    *--sp = 0;
    *--sp = (long long)entry; /* where the first switch returns to, as if it had been called */
    return (char *)(sp - 6);
}

__asm__(".globl thread_switch\n"
        "thread_switch:\n"
        "    push %rbp\n"
        "    push %rbx\n"
        "    push %r12\n"
        "    push %r13\n"
        "    push %r14\n"
        "    push %r15\n"
        "    mov %rsp, (%rdi)\n"
        "    mov %rsi, %rsp\n"
        "    pop %r15\n"
        "    pop %r14\n"
        "    pop %r13\n"
        "    pop %r12\n"
        "    pop %rbx\n"
        "    pop %rbp\n"
        "    ret\n");
