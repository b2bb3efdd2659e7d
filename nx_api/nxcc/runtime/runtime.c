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
#include "../../contract/program_image.h"

/* In the initialised data: a node uses that page anyway. Behind the program's arrays they would cost a page
 * more. */
#define NXC_DATA __attribute__((visibility("hidden"), section(".data")))
NXC_DATA int64_t nxc_left;
NXC_DATA int64_t nxc_lookahead = NXC_NO_LOOKAHEAD;
NXC_DATA int64_t nxc_data_cache = 8192;

/* The price of moving so many bytes (table.h): near, or far if they are not in the cache. */
__attribute__((visibility("hidden"))) int64_t nxc_move(int64_t bytes, int64_t near, int64_t far)
{
    return bytes * (2 * bytes > nxc_data_cache ? far : near);
}

extern int main(int argc, char **argv, char **envp);
extern void (*__init_array_start[])(void) __attribute__((visibility("hidden")));
extern void (*__init_array_end[])(void) __attribute__((visibility("hidden")));
extern void (*__fini_array_start[])(void) __attribute__((visibility("hidden")));
extern void (*__fini_array_end[])(void) __attribute__((visibility("hidden")));
/* The linker's symbols for the ends of section nxc_bodies, if there is one. */
extern const struct nxc_body __start_nxc_bodies[] __attribute__((visibility("hidden"), weak));
extern const struct nxc_body __stop_nxc_bodies[] __attribute__((visibility("hidden"), weak));

/* Of race_runtime.c, which is linked only if a file was compiled with --races or --asan. */
extern const struct nxc_races nxc_races __attribute__((visibility("hidden"), weak));

NXC_DATA struct nxc_path nxc_root = {.recent = &nxc_root};
NXC_DATA struct nxc_path *nxc_path = &nxc_root;

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
    .data_cache = &nxc_data_cache,
    .main = main,
    .init_begin = __init_array_start,
    .init_end = __init_array_end,
    .fini_begin = __fini_array_start,
    .fini_end = __fini_array_end,
    .bodies_begin = __start_nxc_bodies,
    .bodies_end = __stop_nxc_bodies,
    .root = &nxc_root,
    .path = &nxc_path,
    .long_bytes = NXC_LONG_BYTES,
    .races = &nxc_races,
};

/* nxc_enter: the inline assembly of a poll that strikes calls it (count.cc), with the program's stack
 * pointer in nxc_stack_pointer, below which the return address then lies. Nothing is saved but the x87
 * registers; the simulator saves all else, and returns to the program with its stack pointer
 * (kernel/crossing.h). */
__asm__(".data\n"
        ".balign 16\n"
        "    .quad 0\n"
        "nxc_return_address:\n"
        "    .quad 0\n"
        ".globl nxc_stack_pointer\n"
        ".hidden nxc_stack_pointer\n"
        "nxc_stack_pointer:\n"
        "    .quad 0\n");
#ifndef NXC_HOSTED
__asm__(".text\n"
        ".globl nxc_enter\n"
        ".hidden nxc_enter\n"
        ".type nxc_enter, @function\n"
        "nxc_enter:\n"
        "    .cfi_startproc\n"
        "    jmp *nxc_preempt@GOTPCREL(%rip)\n"
        "    .cfi_endproc\n"
        ".size nxc_enter, .-nxc_enter\n");
#else
/* In an ordinary program nxc_preempt is a C function, and all is saved on the program's stack. */
__asm__(
    ".text\n"
    ".globl nxc_enter\n"
    ".hidden nxc_enter\n"
    "nxc_enter:\n"
    "    movq nxc_stack_pointer(%rip), %rsp\n"
    "    pushq nxc_return_address(%rip)\n" NXC_BEGIN_SAVING(
        "nxc_enter_saving") "    subq $264, %rsp\n"
                            "    andq $-16, %rsp\n" NXC_SAVE_SSE "    stmxcsr 256(%rsp)\n"
                            "    call nxc_preempt@PLT\n"
                            "    ldmxcsr 256(%rsp)\n" NXC_RESTORE_SSE NXC_END_ROUTINE("nxc_enter_saving"));
#endif

/* Deeper paths, and more of them, fold recursion: a function's time then counts for the path of the
 * function's nearest call to itself. So the tree is bounded. */
enum { DEEPEST = 200, MOST = 20000 };
static __attribute__((section(".data"))) int64_t paths;

/* The nearest path of the function among those that lead to `at`; NULL: none. */
static struct nxc_path *recursion(struct nxc_path *at, const struct nxc_body *body)
{
    while (at && at->body != body)
        at = at->parent;
    return at;
}

static struct nxc_path *new_child(struct nxc_path *parent, const struct nxc_body *body)
{
    struct nxc_path *p = nxc_new_path(body->slots);
    paths++;
    p->body = body;
    p->recent = &nxc_root;
    p->parent = parent;
    p->next = parent->children;
    p->depth = parent->depth + 1;
    return parent->children = p;
}

/* The path of a function that is called where the program is. */
__attribute__((visibility("hidden"), used)) struct nxc_path *nxc_other_path(const struct nxc_body *body);
struct nxc_path *nxc_other_path(const struct nxc_body *body)
{
    struct nxc_path *parent = nxc_path, *p = parent->children;
    while (p && p->body != body)
        p = p->next;
    if (!p && (parent->depth >= DEEPEST || paths >= MOST))
        p = recursion(parent, body);
    return parent->recent = p ? p : new_child(parent, body);
}

/* nxc_find_path: from the address of a body, in %rax, its path. All other registers stay, but the flags. */
__asm__(".text\n"
        ".globl nxc_find_path\n"
        ".hidden nxc_find_path\n"
        ".type nxc_find_path, @function\n"
        "nxc_find_path:\n"
        "    .cfi_startproc\n"
        "    pushq %rbp\n"
        "    .cfi_def_cfa_offset 16\n"
        "    .cfi_offset %rbp, -16\n"
        "    movq nxc_path(%rip), %rbp\n"
        "    movq 8(%rbp), %rbp\n"
        "    cmpq %rax, (%rbp)\n"
        "    jne 1f\n"
        "    movq %rbp, %rax\n"
        "    popq %rbp\n"
        "    ret\n"
        "1:  movq %rsp, %rbp\n"
        "    .cfi_def_cfa_register %rbp\n"
        "    pushq %rcx\n"
        "    pushq %rdx\n"
        "    pushq %rsi\n"
        "    pushq %rdi\n"
        "    pushq %r8\n"
        "    pushq %r9\n"
        "    pushq %r10\n"
        "    pushq %r11\n"
        "    subq $264, %rsp\n"
        "    andq $-16, %rsp\n" NXC_SAVE_SSE "    movq %rax, %rdi\n"
        "    call nxc_other_path\n" NXC_RESTORE_SSE "    leaq -64(%rbp), %rsp\n"
        "    popq %r11\n"
        "    popq %r10\n"
        "    popq %r9\n"
        "    popq %r8\n"
        "    popq %rdi\n"
        "    popq %rsi\n"
        "    popq %rdx\n"
        "    popq %rcx\n"
        "    popq %rbp\n"
        "    .cfi_def_cfa %rsp, 8\n"
        "    ret\n"
        "    .cfi_endproc\n"
        ".size nxc_find_path, .-nxc_find_path\n");

#ifndef NXC_HOSTED
/* Runs when somebody starts the program in a shell (shell_runtime.c). */
__asm__(".text\n"
        ".globl _start\n"
        ".hidden _start\n"
        ".type _start, @function\n"
        "_start:\n"
        "    movq %rsp, %rdi\n"
        "    andq $-16, %rsp\n"
        "    call nxc_from_shell\n"
        ".size _start, .-_start\n");
#endif
