/* crossing.h - the crossing between a node's program and the system. The program has a stack in its memory;
 * all that it calls runs on another, the fiber's. So what lies below the program's stack pointer depends on
 * the program alone, and holds no address of this computer's: a program that reads there (a local variable
 * whose function has ended) finds the same in every run.
 *
 *     program's stack      main | f |        (handler) |
 *     system's stack       start | call of main | csend | call of the handler | printf
 *                                               ^ level of f              ^ level of the handler
 *
 * The level of the running fiber is where the system's stack begins when the program calls the system
 * again. At a crossing the frame pointers are linked, so that the frames of the system lead to those of
 * the program.
 *
 * A program refers to the system's functions by their gates, short pieces of code at addresses that do not
 * depend on this computer. A gate leads to a crossing of the kind that the function is; on the way back,
 * all registers that hold no answer are cleared. A program that knows the address of errno may keep it while
 * it moves to another thread: its errno is in its own memory, and its gates copy it to and from the C
 * library's. */
#ifndef KERNEL_CROSSING_H
#define KERNEL_CROSSING_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct fiber;

/* What a function answers, and in which registers. */
enum crossing_answer {
    CROSSING_INTEGER, /* or a pointer, or a structure of up to 8 bytes: %rax */
    CROSSING_NOTHING,
    CROSSING_PAIR,    /* a structure of 16 bytes: %rax and %rdx */
    CROSSING_REAL,    /* %xmm0, or the x87 stack */
    CROSSING_COMPLEX, /* %xmm0 and %xmm1, or the x87 stack */
    CROSSING_ANSWERS
};

/* How many of its arguments may lie on the stack. */
enum crossing_stacked {
    CROSSING_NONE,
    CROSSING_SOME /* 64 bytes */,
    CROSSING_MANY /* 1 KB */,
    CROSSING_STACKED
};

/* What a function of the system is to a program. */
enum crossing_kind {
    CROSSING_USUAL, /* a C function: see the two above */
    CROSSING_POLL,  /* nxc_preempt: saves all registers (nx_api/nxcc/runtime/runtime.c) */
    CROSSING_SETJMP /* runs on the program's stack */
};

struct crossing_target {
    void (*function)(void);
    enum crossing_kind kind;
    enum crossing_answer answer;
    enum crossing_stacked stacked;
};

/* Makes the gates of functions, once in a process; aborts with a message if their place is taken. */
void crossing_open(const struct crossing_target *targets, unsigned count);
/* The address of the k-th function's gate, for a program that knows the address of errno or not: the same in
 * every run. */
uintptr_t crossing_gate(unsigned k, bool has_errno);
/* Which one's gate lies at an address; -1: none. */
int crossing_gate_number(uintptr_t address);

/* What lies at the end of a program's stack. */
struct crossing_top {
    int own_errno;
    int has_errno; /* the program's gates are those for programs that know its address */
};

/* f, which is on the system's stack, is to run a program, whose stack ends at `top`. */
void crossing_begin(struct fiber *f, struct crossing_top *top);
/* From the system, on the running fiber: calls a function of the program, on the program's stack, below
 * what has called the system. */
long crossing_call(void *function, long a, long b, long c, long d, long e);
/* The frame (saved frame pointer, return address) of the program's call that the running fiber is in;
 * NULL: the program has not called the system. */
const void *crossing_frame(void);
/* Where that call returns to; there has to be one. */
uintptr_t crossing_caller(void);
/* The program's stack pointer at that call; the end of its stack if there is none. */
uintptr_t crossing_stack_pointer(void);

/* What setjmp keeps, as glibc's jmp_buf has room for it. */
struct crossing_jump {
    uintptr_t registers[6], stack_pointer, at;
    uint32_t level; /* from the lowest byte of the system's stack */
};
/* Has the call of setjmp's caller ended, as a handler has? Then there is no way back. */
bool crossing_may_jump(const struct crossing_jump *j);
_Noreturn void crossing_jump(const struct crossing_jump *j, int value);
#endif
