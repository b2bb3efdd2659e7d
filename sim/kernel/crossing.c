/* crossing.c - see crossing.h. The assembly is for x86-64 and the System V ABI. */
#include "kernel/crossing.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include "kernel/fiber.h"

#define AT(member, offset) _Static_assert(offsetof(struct fiber, member) == (offset), #member)
AT(level, 0);
AT(program_top, 8);
AT(stack, 16);
_Static_assert(offsetof(struct crossing_top, has_errno) == 4, "has_errno");
_Static_assert(offsetof(struct crossing_jump, level) == 64, "struct crossing_jump is glibc's __jmp_buf_tag");

/* The code below finds the running fiber here. */
#define FIBER "    movq %fs:fiber_running@tpoff, %r10\n"

/* A crossing's frame, downwards from the level: return address, frame pointer, the program's stack
 * pointer. For debuggers: the caller's frame is where the third says. */
#define FRAME_IS_LINKED                                                                                      \
    "    .cfi_escape 0x0f, 5, 0x76, 0x78, 0x06, 0x23, 8\n" /* CFA = *(%rbp - 8) + 8 */                       \
    "    .cfi_escape 0x10, 6, 2, 0x76, 0\n"                /* %rbp at %rbp */

#define CLEAR_REAL(n) "    pxor %xmm" #n ", %xmm" #n "\n"
#define EACH_REAL(f) f(2) f(3) f(4) f(5) f(6) f(7) f(8) f(9) f(10) f(11) f(12) f(13) f(14) f(15)
#define CLEAR_REALS EACH_REAL(CLEAR_REAL)
#define CLEAR_INTEGERS                                                                                       \
    "    xorl %ecx, %ecx\n"                                                                                  \
    "    xorl %esi, %esi\n"                                                                                  \
    "    xorl %edi, %edi\n"                                                                                  \
    "    xorl %r8d, %r8d\n"                                                                                  \
    "    xorl %r9d, %r9d\n"                                                                                  \
    "    xorl %r10d, %r10d\n"                                                                                \
    "    xorl %r11d, %r11d\n"
#define CLEAR_RAX "    xorl %eax, %eax\n"
#define CLEAR_RDX "    xorl %edx, %edx\n"

/* Arguments on the stack are copied: they lie behind the return address, at 8(%r10). */
#define COPY_NONE "    subq $8, %rsp\n"
#define COPY_TWO(at)                                                                                         \
    "    movups " #at "+8(%r10), %xmm8\n"                                                                    \
    "    movups %xmm8, " #at "(%rsp)\n"
#define COPY_SOME "    subq $72, %rsp\n" COPY_TWO(0) COPY_TWO(16) COPY_TWO(32) COPY_TWO(48)
#define COPY_MANY                                                                                            \
    "    pushq %rcx\n"                                                                                       \
    "    pushq %rsi\n"                                                                                       \
    "    pushq %rdi\n"                                                                                       \
    "    leaq -1024(%rsp), %rdi\n"                                                                           \
    "    leaq 8(%r10), %rsi\n"                                                                               \
    "    movl $128, %ecx\n"                                                                                  \
    "    rep movsq\n"                                                                                        \
    "    popq %rdi\n"                                                                                        \
    "    popq %rsi\n"                                                                                        \
    "    popq %rcx\n"                                                                                        \
    "    subq $1048, %rsp\n"

/* The C library's errno is the thread's, a program's is its own, at its program_top (crossing.h): the way in
 * takes the value along, and the way back. */
#define ERRNO_IN                                                                                             \
    "    pushq %rcx\n" FIBER "    movq 8(%r10), %rcx\n"                                                      \
    "    movq crossing_errno(%rip), %r10\n"                                                                  \
    "    movl (%rcx), %ecx\n"                                                                                \
    "    movl %ecx, %fs:(%r10)\n"                                                                            \
    "    popq %rcx\n"
#define ERRNO_OUT                                                                                            \
    FIBER "    movq 8(%r10), %rcx\n"                                                                         \
          "    movq crossing_errno(%rip), %r10\n"                                                            \
          "    movl %fs:(%r10), %r10d\n"                                                                     \
          "    movl %r10d, (%rcx)\n"

/* A crossing to the function in %r11. */
#define CROSSING(name, copy, in, out, clear)                                                                 \
    ".hidden " name "\n.globl " name "\n.type " name ", @function\n" name ":\n"                              \
    "    .cfi_startproc\n"                                                                                   \
    "    cld\n" FIBER "    movq (%r10), %r10\n"                                                              \
    "    xchgq %rsp, %r10\n"                                                                                 \
    "    .cfi_def_cfa %r10, 8\n"                                                                             \
    "    pushq (%r10)\n"                                                                                     \
    "    pushq %rbp\n"                                                                                       \
    "    movq %rsp, %rbp\n" FRAME_IS_LINKED "    pushq %r10\n" copy in "    call *%r11\n" out                \
    "    movq -8(%rbp), %rsp\n"                                                                              \
    "    movq (%rbp), %rbp\n"                                                                                \
    "    .cfi_def_cfa %rsp, 8\n"                                                                             \
    "    .cfi_same_value %rbp\n" clear CLEAR_INTEGERS CLEAR_REALS "    ret\n"                                \
    "    .cfi_endproc\n"                                                                                     \
    ".size " name ", .-" name "\n"

#define CLEAR_INTEGER CLEAR_RDX CLEAR_REAL(0) CLEAR_REAL(1)
#define CLEAR_NOTHING CLEAR_RAX CLEAR_RDX CLEAR_REAL(0) CLEAR_REAL(1)
#define CLEAR_PAIR CLEAR_REAL(0) CLEAR_REAL(1)
#define CLEAR_ANSWER_REAL CLEAR_RAX CLEAR_RDX CLEAR_REAL(1)
#define CLEAR_COMPLEX CLEAR_RAX CLEAR_RDX

#define CROSSINGS(stacked, copy, in, out)                                                                    \
    CROSSING("crossing_integer_" stacked, copy, in, out, CLEAR_INTEGER)                                      \
    CROSSING("crossing_nothing_" stacked, copy, in, out, CLEAR_NOTHING)                                      \
    CROSSING("crossing_pair_" stacked, copy, in, out, CLEAR_PAIR)                                            \
    CROSSING("crossing_real_" stacked, copy, in, out, CLEAR_ANSWER_REAL)                                     \
    CROSSING("crossing_complex_" stacked, copy, in, out, CLEAR_COMPLEX)

__asm__(".text\n" CROSSINGS("none", COPY_NONE, "", "") CROSSINGS("some", COPY_SOME, "", "")
            CROSSINGS("many", COPY_MANY, "", "") CROSSINGS("errno_none", COPY_NONE, ERRNO_IN, ERRNO_OUT)
                CROSSINGS("errno_some", COPY_SOME, ERRNO_IN, ERRNO_OUT)
                    CROSSINGS("errno_many", COPY_MANY, ERRNO_IN, ERRNO_OUT));

/* Where a thread's errno is, from %fs on. */
uintptr_t crossing_errno __attribute__((visibility("hidden")));

#define SAVE(n) "    movaps %xmm" #n ", 16*" #n "(%rsp)\n"
#define RESTORE(n) "    movaps 16*" #n "(%rsp), %xmm" #n "\n"
#define ALL_REALS(f) f(0) f(1) EACH_REAL(f)

/* What a poll calls. */
void (*crossing_poll_function)(void);
/* Where a poll goes on, while all registers have the program's values. */
_Thread_local uintptr_t crossing_poll_returns;
_Thread_local uintptr_t crossing_poll_r10;

/* A poll. Nothing has been saved; the program goes on at 0(%rsp), with the stack pointer in 8(%rsp). Both
 * are in its data (nx_api/nxcc/runtime/runtime.c) and are cleared, so that its memory does not tell of polls.
 * Saves all but the x87 registers, which the program expects to be changed. */
__asm__(".text\n"
        ".hidden crossing_poll\n.globl crossing_poll\n.type crossing_poll, @function\n"
        "crossing_poll:\n"
        "    .cfi_startproc\n"
        "    .cfi_def_cfa %rsp, 8\n"
        "    movq %r10, %fs:crossing_poll_r10@tpoff\n" FIBER "    movq (%r10), %r10\n"
        "    xchgq %rsp, %r10\n"
        "    pushq (%r10)\n"
        "    movq $0, (%r10)\n"
        "    pushq %rbp\n"
        "    movq %rsp, %rbp\n"
        "    pushq 8(%r10)\n"
        "    movq $0, 8(%r10)\n"
        "    .cfi_escape 0x0f, 3, 0x76, 0x78, 0x06\n" /* CFA = *(%rbp - 8) */
        "    .cfi_escape 0x10, 6, 2, 0x76, 0\n"       /* %rbp at %rbp */
        "    .cfi_escape 0x10, 16, 2, 0x76, 8\n"      /* return address at %rbp + 8 */
        "    pushq %fs:crossing_poll_r10@tpoff\n"
        "    pushfq\n"
        "    cld\n"
        "    pushq %rax\n"
        "    pushq %rcx\n"
        "    pushq %rdx\n"
        "    pushq %rsi\n"
        "    pushq %rdi\n"
        "    pushq %r8\n"
        "    pushq %r9\n"
        "    pushq %r11\n"
        "    subq $280, %rsp\n" /* 104 bytes below the level, which is a multiple of 16 */
        ALL_REALS(SAVE) "    stmxcsr 256(%rsp)\n"
                        "    call *crossing_poll_function(%rip)\n"
                        "    ldmxcsr 256(%rsp)\n" ALL_REALS(
                            RESTORE) "    addq $280, %rsp\n"
                                     "    popq %r11\n"
                                     "    popq %r9\n"
                                     "    popq %r8\n"
                                     "    popq %rdi\n"
                                     "    popq %rsi\n"
                                     "    popq %rdx\n"
                                     "    popq %rcx\n"
                                     "    popq %rax\n"
                                     "    movq 8(%rbp), %r10\n"
                                     "    movq %r10, %fs:crossing_poll_returns@tpoff\n"
                                     "    popfq\n"
                                     "    popq %r10\n"
                                     "    movq -8(%rbp), %rsp\n"
                                     "    movq (%rbp), %rbp\n"
                                     "    jmp *%fs:crossing_poll_returns@tpoff\n"
                                     "    .cfi_endproc\n"
                                     ".size crossing_poll, .-crossing_poll\n");

/* setjmp, on the program's stack. */
__asm__(".text\n"
        ".hidden crossing_setjmp\n.globl crossing_setjmp\n.type crossing_setjmp, @function\n"
        "crossing_setjmp:\n"
        "    .cfi_startproc\n"
        "    movq %rbx, (%rdi)\n"
        "    movq %rbp, 8(%rdi)\n"
        "    movq %r12, 16(%rdi)\n"
        "    movq %r13, 24(%rdi)\n"
        "    movq %r14, 32(%rdi)\n"
        "    movq %r15, 40(%rdi)\n"
        "    leaq 8(%rsp), %rax\n"
        "    movq %rax, 48(%rdi)\n"
        "    movq (%rsp), %rax\n"
        "    movq %rax, 56(%rdi)\n" FIBER "    movq (%r10), %rax\n"
        "    subq 16(%r10), %rax\n"
        "    movl %eax, 64(%rdi)\n"
        "    xorl %eax, %eax\n"
        "    xorl %r10d, %r10d\n"
        "    xorl %r11d, %r11d\n"
        "    ret\n"
        "    .cfi_endproc\n"
        ".size crossing_setjmp, .-crossing_setjmp\n"

        ".hidden crossing_resume\n.globl crossing_resume\n.type crossing_resume, @function\n"
        "crossing_resume:\n" /* the jump in %rdi, the value in %esi */
        "    .cfi_startproc\n" FIBER "    movl 64(%rdi), %eax\n"
        "    addq 16(%r10), %rax\n"
        "    movq %rax, (%r10)\n"
        "    movq (%rdi), %rbx\n"
        "    movq 8(%rdi), %rbp\n"
        "    movq 16(%rdi), %r12\n"
        "    movq 24(%rdi), %r13\n"
        "    movq 32(%rdi), %r14\n"
        "    movq 40(%rdi), %r15\n"
        "    movq 48(%rdi), %rsp\n"
        "    movl %esi, %eax\n"
        "    movq 56(%rdi), %rdx\n" CLEAR_INTEGERS CLEAR_REAL(0) CLEAR_REAL(1) CLEAR_REALS
        "    jmp *%rdx\n"
        "    .cfi_endproc\n"
        ".size crossing_resume, .-crossing_resume\n");

/* Calls of the program. What the program finds in registers and below its frame is its own, or 0. The call
 * itself is made by code among the gates (crossing_calls), since its return address lies on the program's
 * stack. */
extern uintptr_t crossing_calls __attribute__((visibility("hidden")));
__asm__(".text\n"
        ".hidden crossing_call\n.globl crossing_call\n.type crossing_call, @function\n"
        "crossing_call:\n"
        "    .cfi_startproc\n"
        "    pushq %rbp\n"
        "    .cfi_def_cfa_offset 16\n"
        "    .cfi_offset %rbp, -16\n"
        "    movq %rsp, %rbp\n"
        "    .cfi_def_cfa_register %rbp\n"
        "    pushq %rbx\n"
        "    pushq %r12\n"
        "    pushq %r13\n"
        "    pushq %r14\n"
        "    pushq %r15\n" FIBER "    movq (%r10), %r11\n"
        "    pushq %r11\n"
        "    movq %rsp, (%r10)\n" /* a multiple of 16 */
        "    xorl %ebx, %ebx\n"
        "    xorl %r12d, %r12d\n"
        "    movq 8(%r10), %rax\n"
        "    testq %r11, %r11\n"
        "    je 1f\n"
        "    movq -8(%r11), %rbx\n"
        "    movq -16(%r11), %r12\n"
        "    movq -24(%r11), %rax\n"
        "1:  andq $-16, %rax\n"
        "    movq %rdi, %r11\n"
        "    movq %rsi, %rdi\n"
        "    movq %rdx, %rsi\n"
        "    movq %rcx, %rdx\n"
        "    movq %r8, %rcx\n"
        "    movq %r9, %r8\n"
        "    movq crossing_calls(%rip), %r10\n"
        "    movq %rax, %rsp\n"
        "    pushq %rbx\n"
        "    pushq %r12\n"
        "    movq %rsp, %rbp\n"
        "    xorl %ebx, %ebx\n"
        "    xorl %r12d, %r12d\n"
        "    xorl %r13d, %r13d\n"
        "    xorl %r14d, %r14d\n"
        "    xorl %r15d, %r15d\n"
        "    xorl %r9d, %r9d\n"
        "    xorl %eax, %eax\n" CLEAR_REAL(0) CLEAR_REAL(1) CLEAR_REALS
        "    jmp *%r10\n"
        "    .cfi_endproc\n"
        ".size crossing_call, .-crossing_call\n"

        ".hidden crossing_returned\n.globl crossing_returned\n.type crossing_returned, @function\n"
        "crossing_returned:\n"
        "    .cfi_startproc\n"
        "    .cfi_undefined %rip\n"
        "    cld\n" FIBER "    movq 8(%r10), %rcx\n"
        "    cmpl $0, 4(%rcx)\n" /* has_errno */
        "    je 1f\n"
        "    movl (%rcx), %ecx\n"
        "    movq crossing_errno(%rip), %r11\n"
        "    movl %ecx, %fs:(%r11)\n"
        "1:  movq (%r10), %rsp\n"
        "    popq %r11\n"
        "    movq %r11, (%r10)\n"
        "    popq %r15\n"
        "    popq %r14\n"
        "    popq %r13\n"
        "    popq %r12\n"
        "    popq %rbx\n"
        "    popq %rbp\n"
        "    ret\n"
        "    .cfi_endproc\n"
        ".size crossing_returned, .-crossing_returned\n");

/* --- gates --- */

enum { GATE = 32, GATES_AT = 32 << 20 };
static char *gates;
static unsigned gate_count;
uintptr_t crossing_calls;

static char *put(char *at, const void *bytes, size_t count)
{
    memcpy(at, bytes, count);
    return at + count;
}

/* movabs $value, %r10 or %r11 */
static char *put_load(char *at, unsigned reg, uintptr_t value)
{
    const unsigned char load[] = {0x49, (unsigned char)(0xb0 + reg)};
    return put(put(at, load, sizeof load), &value, sizeof value);
}

static const unsigned char JUMP_R10[] = {0x41, 0xff, 0xe2}, CALL_R11[] = {0x41, 0xff, 0xd3},
                           JUMP_NEXT[] = {0xff, 0x25, 0, 0, 0, 0}; /* to where the next 8 bytes say */

#define NAMES(stacked)                                                                                       \
    extern void crossing_integer_##stacked(void), crossing_nothing_##stacked(void),                          \
        crossing_pair_##stacked(void), crossing_real_##stacked(void), crossing_complex_##stacked(void)
NAMES(none);
NAMES(some);
NAMES(many);
NAMES(errno_none);
NAMES(errno_some);
NAMES(errno_many);
#define KINDS(stacked)                                                                                       \
    {                                                                                                        \
        crossing_integer_##stacked, crossing_nothing_##stacked, crossing_pair_##stacked,                     \
            crossing_real_##stacked, crossing_complex_##stacked                                              \
    }
static void (*const usual[2][CROSSING_STACKED][CROSSING_ANSWERS])(void) = {
    {KINDS(none), KINDS(some), KINDS(many)}, {KINDS(errno_none), KINDS(errno_some), KINDS(errno_many)}};
extern void crossing_poll(void), crossing_setjmp(void), crossing_returned(void);
extern _Noreturn void crossing_resume(const struct crossing_jump *j, int value);

static void fill_gate(char *at, const struct crossing_target *t, bool has_errno)
{
    void (*direct)(void) = t->kind == CROSSING_POLL ? crossing_poll : crossing_setjmp;
    if (t->kind == CROSSING_USUAL) {
        at = put_load(at, 11, (uintptr_t)t->function);
        put(put_load(at, 10, (uintptr_t)usual[has_errno][t->stacked][t->answer]), JUMP_R10, sizeof JUMP_R10);
    } else {
        if (t->kind == CROSSING_POLL)
            crossing_poll_function = t->function;
        put(put(at, JUMP_NEXT, sizeof JUMP_NEXT), &direct, sizeof direct);
    }
}

/* Gates of programs that have errno come second. The last is no gate, but what crossing_call needs there. */
static void fill(const struct crossing_target *targets)
{
    for (unsigned k = 0; k < 2 * gate_count; k++)
        fill_gate(gates + k * GATE, &targets[k % gate_count], k >= gate_count);
    char *at = gates + 2 * gate_count * GATE;
    crossing_calls = (uintptr_t)at;
    at = put_load(put(at, CALL_R11, sizeof CALL_R11), 10, (uintptr_t)crossing_returned);
    put(at, JUMP_R10, sizeof JUMP_R10);
}

void crossing_open(const struct crossing_target *targets, unsigned count)
{
    size_t bytes = (2 * count + 1) * GATE;
    char *thread;
    void *there = (void *)(uintptr_t)GATES_AT;
    __asm__("movq %%fs:0, %0" : "=r"(thread));
    crossing_errno = (uintptr_t)&errno - (uintptr_t)thread;
    gates =
        mmap(there, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED_NOREPLACE, -1, 0);
    if (gates != MAP_FAILED)
        gate_count = count, fill(targets);
    if (gates == MAP_FAILED || mprotect(gates, bytes, PROT_READ | PROT_EXEC)) {
        perror("touchstone: the gates of node programs, at 32 MB");
        abort();
    }
}

uintptr_t crossing_gate(unsigned k, bool has_errno)
{
    return (uintptr_t)gates + (has_errno ? gate_count + k : k) * GATE;
}

int crossing_gate_number(uintptr_t address)
{
    uintptr_t offset = address - (uintptr_t)gates;
    bool is_gate = gates && offset < (uintptr_t)2 * gate_count * GATE && offset % GATE == 0;
    return is_gate ? (int)(offset / GATE % gate_count) : -1;
}

/* --- the running fiber's --- */

void crossing_begin(struct fiber *f, struct crossing_top *top)
{
    f->level = NULL;
    f->program_top = top;
}

static const uintptr_t *level(void)
{
    const struct fiber *f = fiber_current();
    return f ? f->level : NULL;
}

const void *crossing_frame(void)
{
    const uintptr_t *at = level();
    return at ? at - 2 : NULL;
}

uintptr_t crossing_caller(void)
{
    return level()[-1];
}

uintptr_t crossing_stack_pointer(void)
{
    const uintptr_t *at = level();
    return at ? at[-3] : (uintptr_t)fiber_current()->program_top;
}

bool crossing_may_jump(const struct crossing_jump *j)
{
    const struct fiber *f = fiber_current();
    return j->level && (char *)f->stack + j->level >= (char *)f->level;
}

_Noreturn void crossing_jump(const struct crossing_jump *j, int value)
{
    const struct fiber *f = fiber_current();
    fiber_abandon((char *)f->stack + j->level);
    crossing_resume(j, value ? value : 1);
}
