/* crash.c - see crash.h. */
#include "machine/crash.h"
#include <assert.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <asm/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>
#include "files/virtual_time.h"
#include "kernel/crossing.h"
#include "kernel/xalloc.h"
#include "kernel/fiber.h"
#include "guest/image.h"
#include "guest/backtrace.h"
#include "guest/refusal.h"
#include "node/self.h"

/* The stack of a thread's signal handlers, which grows down towards the rest. A program may have lost the way
 * to thread-local variables; a handler finds this by its stack. */
struct crash_guard {
    uint64_t mark;
    void *thread_pointer;    /* what %fs is to point to */
    struct node_crash crash; /* the latest, until crash_keep() */
    char stack[1 << 16];
};

static const uint64_t MARK = UINT64_C(0x6372617368206d65);

static const int FAULTS[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS};
enum { FAULT_COUNT = sizeof FAULTS / sizeof FAULTS[0] };

enum { IN_PLACE = 1 }; /* MPI_IN_PLACE as an address */
enum { MOST_FRAMES = sizeof(((struct node_crash *)0)->frames) / sizeof(uintptr_t) };

/* A library function that crashed ran on the system's stack, where the program called it. */
static void note_frames(struct node_crash *c, const struct node *n, const greg_t *r)
{
    c->frames[0] = (uintptr_t)r[REG_RIP] - (c->signal == SIGSYS); /* this one comes behind its instruction */
    c->depth = 1;
    c->in_library = !backtrace_in_program(n, c->frames[0]);
    uintptr_t frame = (uintptr_t)r[REG_RBP], below = (uintptr_t)r[REG_RSP] - (uintptr_t)n->guest.system_stack;
    if (c->in_library && below < NODE_SYSTEM_STACK)
        frame = (uintptr_t)crossing_frame();
    c->depth += backtrace_walk(n, frame, c->frames + c->depth, MOST_FRAMES - c->depth);
}

/* The processor tells no address that is none, as 0x3ff8000000000000. It is in a register, since no
 * instruction has room for it; 0: none is. */
static uintptr_t no_address(const greg_t *r)
{
    for (int i = REG_R8; i <= REG_RSP; i++)
        if (r[i] >> 47 != 0 && r[i] >> 47 != -1)
            return (uintptr_t)r[i];
    return 0;
}

/* Did the processor refuse an instruction for another reason than its address, so that it tells none? */
static bool tells_no_address(const struct node_crash *c)
{
    return (c->signal == SIGSEGV || c->signal == SIGBUS) && c->code == SI_KERNEL;
}

/* Did an instruction fault that addresses memory by %fs? Then the register is wrong, whatever it holds by
 * now: some kernels set it right when they give the processor to another thread and back. An instruction at
 * whose own bytes the fault lies cannot be read. */
static bool faults_by_fs(int signal, const siginfo_t *info, const greg_t *r)
{
    enum { FS_PREFIX = 0x64, LONGEST = 15 };
    const uint8_t *instruction = (const uint8_t *)r[REG_RIP];
    return signal == SIGSEGV && info->si_code != SI_KERNEL &&
           (uintptr_t)info->si_addr - (uintptr_t)instruction >= LONGEST && *instruction == FS_PREFIX;
}

static void note_crash(struct node_crash *c, struct node *n, int signal, const siginfo_t *info,
                       const greg_t *r)
{
    c->signal = signal, c->code = info->si_code;
    c->lost_thread |= faults_by_fs(signal, info, r);
    c->address = signal == SIGSYS      ? (uintptr_t)info->si_syscall
                 : tells_no_address(c) ? no_address(r)
                                       : (uintptr_t)info->si_addr;
    c->top = backtrace_in_stack(n, (uintptr_t)r[REG_RSP]) ? *(uintptr_t *)r[REG_RSP] : 0;
    note_frames(c, n, r);
    n->cold->crash = c;
}

/* The C library's own function of this name reaches a thread's variables. */
static void thread_pointer(int how, void *p)
{
    long result = SYS_arch_prctl;
    __asm__ volatile("syscall" : "+a"(result) : "D"((long)how), "S"(p) : "rcx", "r11", "memory");
}

/* The guard of the thread to which a signal came, NULL if it has none. From here on the thread has its
 * variables again. */
__attribute__((no_stack_protector)) static struct crash_guard *guard_of(const ucontext_t *context)
{
    struct crash_guard *g = context->uc_stack.ss_sp;
    void *found;
    if (context->uc_stack.ss_flags & SS_DISABLE || !g || g->mark != MARK)
        return NULL;
    thread_pointer(ARCH_GET_FS, &found);
    thread_pointer(ARCH_SET_FS, g->thread_pointer);
    g->crash.lost_thread = found != g->thread_pointer;
    return g;
}

/* A fault of the simulator's own, perhaps since a program has written to its memory. */
static void end_process(int signal)
{
    static const char TEXT[] =
        "touchstone: a fault outside of all programs. One of them has written to memory "
        "that is not its own, or touchstone has an error\n";
    (void)!write(STDERR_FILENO, TEXT, sizeof TEXT - 1);
    struct sigaction usual = {.sa_handler = SIG_DFL};
    sigaction(signal, &usual, NULL);
    raise(signal);
}

__attribute__((no_stack_protector)) static void on_fault(int signal, siginfo_t *info, void *context)
{
    struct crash_guard *g = guard_of(context);
    struct fiber *f = g ? fiber_current() : NULL;
    if (!f) {
        end_process(signal);
        return;
    }
    note_crash(&g->crash, fiber_arg(f), signal, info, ((ucontext_t *)context)->uc_mcontext.gregs);
    fiber_finish(f);
}

void crash_end_computing(int signal, siginfo_t *info, void *context)
{
    struct crash_guard *g = guard_of(context);
    struct fiber *f = g ? fiber_current() : NULL;
    const greg_t *r = ((ucontext_t *)context)->uc_mcontext.gregs;
    if (!f || !backtrace_in_program(fiber_arg(f), (uintptr_t)r[REG_RIP]))
        return;
    note_crash(&g->crash, fiber_arg(f), signal, info, r);
    fiber_finish(f);
}

bool crash_is_fault(const struct node *n)
{
    for (int i = 0; i < FAULT_COUNT; i++)
        if (n->cold->crash->signal == FAULTS[i])
            return true;
    return false;
}

void crash_catch(void)
{
    struct sigaction a = {.sa_sigaction = on_fault, .sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER};
    for (int i = 0; i < FAULT_COUNT; i++)
        sigaction(FAULTS[i], &a, NULL);
}

struct crash_guard *crash_watch(void)
{
    struct crash_guard *g = xcalloc(1, sizeof *g);
    g->mark = MARK;
    __asm__("mov %%fs:0, %0" : "=r"(g->thread_pointer));
    stack_t s = {.ss_sp = g, .ss_size = sizeof *g};
    sigaltstack(&s, NULL);
    return g;
}

void crash_unwatch(struct crash_guard *g)
{
    stack_t none = {.ss_flags = SS_DISABLE};
    sigaltstack(&none, NULL);
    free(g);
}

void *crash_thread_begins(void)
{
    return crash_watch();
}

void crash_thread_ends(void *own)
{
    crash_unwatch(own);
}

void crash_keep(struct node *n)
{
    assert(n->cold->crash);
    struct node_crash *kept = xmalloc(sizeof *kept);
    *kept = *n->cold->crash;
    n->cold->crash = kept;
}

/* Of floating-point exceptions only those that a program has unmasked are faults. */
static const char *arithmetic_text(int code)
{
    switch (code) {
    case FPE_FLTDIV:
        return "floating-point division by zero, an exception that it has unmasked";
    case FPE_FLTOVF:
        return "floating-point overflow, an exception that it has unmasked";
    case FPE_FLTUND:
        return "floating-point underflow, an exception that it has unmasked";
    case FPE_FLTRES:
        return "inexact floating-point result, an exception that it has unmasked";
    case FPE_FLTINV:
        return "invalid floating-point operation, an exception that it has unmasked";
    default:
        return "integer division by zero or overflow";
    }
}

static const char *fault_text(const struct node_crash *g)
{
    if (g->lost_thread)
        return "it has changed the register fs, by which the C library finds its own variables";
    switch (g->signal) {
    case SIGSEGV:
    case SIGBUS:
        return tells_no_address(g) && !g->address ? "it executed an instruction that programs may not"
                                                  : "it used an address it may not";
    case SIGFPE:
        return arithmetic_text(g->code);
    case SIGILL:
        return "illegal instruction";
    case SIGABRT:
        return "abort";
    case SIGSYS:
        return "it made a system call, which programs may not";
    default:
        return "trap";
    }
}

/* The address of which a program that keeps addresses in ints has kept the lower half, so that it used
 * `used`; 0: that is no node's. */
static uintptr_t cut_address(const struct node *n, uintptr_t used)
{
    uintptr_t half = UINT32_MAX, whole = ((uintptr_t)n->guest.span & ~half) | (used & half);
    return whole != used && node_owner(n->sys, whole) ? whole : 0;
}

static void print_cut(FILE *f, const struct node *n, uintptr_t whole)
{
    fprintf(
        f, "\n  an address kept in an int? 0x%zx is in the memory of %s; an int holds addresses below 2 GB: ",
        (size_t)whole, node_owner(n->sys, whole)->cold->name);
    fprintf(f, "%s",
            node_image_is_long32(n->guest.file)
                ? "run it on fewer nodes, or on nodes with less memory (--set node.memory_mb=N)"
                : "nxcc --long32 gives the nodes such");
}

/* Is the address in the guard behind the end of a part of the node's memory? */
static bool is_behind(uintptr_t address, const char *end)
{
    return address - (uintptr_t)end < 1 << 16;
}

/* The stack ends where the program begins. The first page of the program is the head of its file, to which
 * no pointer leads: who writes there has come from the stack. */
static bool is_above_stack(const struct node *n, uintptr_t address)
{
    return address - (uintptr_t)n->guest.program < 4096;
}

static void print_cause(FILE *f, const struct node *n)
{
    const struct node_crash *g = n->cold->crash;
    uintptr_t stack = (uintptr_t)n->guest.stack;
    bool memory = (g->signal == SIGSEGV || g->signal == SIGBUS) && !g->lost_thread && !tells_no_address(g);
    const struct node *owner = memory ? node_owner(n->sys, g->address) : NULL;
    uintptr_t whole = memory ? cut_address(n, g->address) : 0;
    fprintf(f, "%s (%s)", fault_text(g), strsignal(g->signal));
    if (g->signal == SIGSYS)
        fprintf(f, ": number %zu; they call functions of C and NX (doc/host-files.md)", (size_t)g->address);
    else if (tells_no_address(g) && !g->lost_thread && g->address)
        fprintf(f, ": 0x%zx, a number or text used as a pointer, or one that was never set",
                (size_t)g->address);
    else if (memory && g->address < stack && g->address >= stack - (1 << 16))
        fprintf(f, ": its stack of %zu KB overflowed (--set node.stack_kb=N gives more)",
                (size_t)(n->sys->cfg->stack_bytes >> 10));
    else if (memory && g->address == 0)
        fprintf(f, ": a null pointer");
    else if (memory && g->address < 4096)
        fprintf(f, ": 0x%zx, a member of a null pointer, or a number that is no address", (size_t)g->address);
    else if (owner && owner != n)
        fprintf(f, ": 0x%zx, in the memory of %s", (size_t)g->address, owner->cold->name);
    else if (memory && is_above_stack(n, g->address) && g->address != g->frames[0])
        fprintf(f, ": 0x%zx, past the end of its stack (is an array too small for what is written into it?)",
                (size_t)g->address);
    else if (memory && g->address - (uintptr_t)n->guest.program < n->guest.image_bytes &&
             g->address != g->frames[0])
        fprintf(f,
                ": 0x%zx, in its code or constants, which cannot be changed (a text in quotes is a constant)",
                (size_t)g->address);
    else if (memory && is_behind(g->address, n->guest.program + n->guest.image_bytes))
        fprintf(f, ": 0x%zx, past the end of its static data", (size_t)g->address);
    else if (memory && is_behind(g->address, n->guest.heap_start + n->guest.region->heap_bytes))
        fprintf(f, ": 0x%zx, past the end of its heap", (size_t)g->address);
    else if (memory)
        fprintf(f, ": 0x%zx", (size_t)g->address);
    if (whole)
        print_cut(f, n, whole);
    if (memory)
        refusal_print(f, n);
}

/* Does the function at pc keep a frame? GCC gives none to a function that only computes; then the caller's
 * address is on top of the stack, and the frames do not show it. */
static bool has_frame(const struct node *n, uintptr_t pc)
{
    enum { PUSH_RBP = 0x55 };
    static const unsigned char ENDBR64[] = {0xf3, 0x0f, 0x1e, 0xfa};
    size_t start = node_image_function(n->guest.file, pc - (uintptr_t)n->guest.program);
    const unsigned char *code = (unsigned char *)n->guest.program + start;
    return code[memcmp(code, ENDBR64, sizeof ENDBR64) ? 0 : sizeof ENDBR64] == PUSH_RBP;
}

/* The addresses of the frames, the innermost first, at most MOST_FRAMES + 1; how many. */
static int frames_of(const struct node *n, uintptr_t frames[])
{
    const struct node_crash *g = n->cold->crash;
    int depth = 0;
    frames[depth++] = g->frames[0];
    if (g->in_library || !has_frame(n, g->frames[0]))
        frames[depth++] = g->top - 1;
    for (int i = 1; i < g->depth; i++)
        frames[depth++] = g->frames[i] - 1;
    return depth;
}

/* MPI's library uses what the program gave to one of its calls: the fault is the call's, whose line the
 * program knows. */
static void print_given(FILE *f, const struct node_crash *g, const char *call)
{
    if (g->address == IN_PLACE)
        fprintf(f, "\n  0x1 is MPI_IN_PLACE, which is not for this argument of %s, or not on this rank",
                call);
    else
        fprintf(f,
                "\n  Look at the arguments of %s: is each buffer or list there, and as long as it should be?",
                call);
}

static void print_frames(FILE *f, const struct node *n, const uintptr_t *frames, int depth)
{
    const struct node_crash *g = n->cold->crash;
    if (g->in_library && !n->call.name) {
        const char *called = g->depth > 1 ? backtrace_called(n, g->frames[1]) : NULL;
        bool to_none = g->signal == SIGSEGV && g->address == g->frames[0];
        fprintf(f, "\n  in %s",
                to_none  ? "no function: it called a pointer that leads to none"
                : called ? called
                         : "a library function");
    }
    backtrace_print(f, n, "in", frames, depth);
}

char *crash_report(const struct node *n)
{
    const struct node_crash *g = n->cold->crash;
    assert(g && g->depth > 0);
    char *text = NULL;
    size_t size;
    uintptr_t frames[MOST_FRAMES + 1];
    int depth = frames_of(n, frames), outside;
    const char *mpi = backtrace_mpi_call(n, frames, depth, &outside), *call = mpi ? mpi : n->call.name;
    FILE *f = xchecked(open_memstream(&text, &size));
    fprintf(f, "%s crashed at %s%s, %s%s: ", n->cold->name, n->call.name ? "" : "or shortly before ",
            virtual_time_moment(n->stats.ended_at).text, call ? "in " : "computing", call ? call : "");
    print_cause(f, n);
    if (mpi && outside < depth) {
        print_given(f, g, mpi);
        backtrace_print(f, n, "called from", frames + outside, depth - outside);
    } else {
        print_frames(f, n, frames, depth);
    }
    fclose(f);
    return text;
}
