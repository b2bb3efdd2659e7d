/* crash.c - see crash.h. */
#include "machine/crash.h"
#include <assert.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <ucontext.h>
#include "files/virtual_time.h"
#include "kernel/crossing.h"
#include "kernel/xalloc.h"
#include "kernel/fiber.h"
#include "guest/image.h"
#include "guest/backtrace.h"
#include "node/self.h"

struct crash_guard {
    struct node_crash crash; /* the latest, until crash_keep() */
    char stack[1 << 16];     /* the signal handler's stack */
};

static _Thread_local struct crash_guard *guard;

static const int FAULTS[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS};
enum { FAULT_COUNT = sizeof FAULTS / sizeof FAULTS[0] };

enum { MOST_FRAMES = sizeof(((struct node_crash *)0)->frames) / sizeof(uintptr_t) };

/* A library function that crashed ran on the system's stack, where the program called it. */
static void note_frames(struct node_crash *c, const struct node *n, const greg_t *r)
{
    c->frames[0] = (uintptr_t)r[REG_RIP] - (c->signal == SIGSYS); /* this one comes behind its instruction */
    c->depth = 1;
    c->in_library = !backtrace_in_program(n, c->frames[0]);
    uintptr_t frame = (uintptr_t)r[REG_RBP], below = (uintptr_t)r[REG_RSP] - (uintptr_t)n->system_stack;
    if (c->in_library && below < NODE_SYSTEM_STACK)
        frame = (uintptr_t)crossing_frame();
    c->depth += backtrace_walk(n, frame, c->frames + c->depth, MOST_FRAMES - c->depth);
}

static void on_fault(int signal, siginfo_t *info, void *context)
{
    struct crash_guard *g = guard;
    struct fiber *f = fiber_current();
    if (!g || !f) {
        struct sigaction usual = {.sa_handler = SIG_DFL};
        sigaction(signal, &usual, NULL);
        raise(signal);
        return;
    }
    struct node *n = fiber_arg(f);
    const greg_t *r = ((ucontext_t *)context)->uc_mcontext.gregs;
    g->crash.signal = signal;
    g->crash.address = signal == SIGSYS ? (uintptr_t)info->si_syscall : (uintptr_t)info->si_addr;
    g->crash.top = backtrace_in_stack(n, (uintptr_t)r[REG_RSP]) ? *(uintptr_t *)r[REG_RSP] : 0;
    note_frames(&g->crash, n, r);
    n->crash = &g->crash;
    fiber_finish(f);
}

void crash_catch(void)
{
    struct sigaction a = {.sa_sigaction = on_fault, .sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER};
    for (int i = 0; i < FAULT_COUNT; i++)
        sigaction(FAULTS[i], &a, NULL);
}

void crash_ignore(void)
{
    struct sigaction usual = {.sa_handler = SIG_DFL};
    for (int i = 0; i < FAULT_COUNT; i++)
        sigaction(FAULTS[i], &usual, NULL);
}

struct crash_guard *crash_watch(void)
{
    assert(!guard);
    guard = xcalloc(1, sizeof *guard);
    stack_t s = {.ss_sp = guard->stack, .ss_size = sizeof guard->stack};
    sigaltstack(&s, NULL);
    return guard;
}

void crash_unwatch(struct crash_guard *g)
{
    assert(g == guard);
    stack_t none = {.ss_flags = SS_DISABLE};
    sigaltstack(&none, NULL);
    guard = NULL;
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
    assert(n->crash);
    struct node_crash *kept = xmalloc(sizeof *kept);
    *kept = *n->crash;
    n->crash = kept;
}

static const char *signal_text(int s)
{
    switch (s) {
    case SIGSEGV:
    case SIGBUS:
        return "it used an address it may not";
    case SIGFPE:
        return "integer division by zero or overflow";
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

/* The node in whose memory an address lies; NULL if there is none. */
static const struct node *owner_of(const struct node_system *s, uintptr_t address)
{
    for (uint32_t i = 0; i < s->count; i++)
        if (node_owns(s->nodes[i], address))
            return s->nodes[i];
    return NULL;
}

/* Is the address in the guard behind the end of a part of the node's memory? */
static bool is_behind(uintptr_t address, const char *end)
{
    return address - (uintptr_t)end < 1 << 16;
}

static void print_cause(FILE *f, const struct node *n)
{
    const struct node_crash *g = n->crash;
    uintptr_t stack = (uintptr_t)n->stack;
    bool memory = g->signal == SIGSEGV || g->signal == SIGBUS;
    const struct node *owner = memory ? owner_of(n->sys, g->address) : NULL;
    fprintf(f, "%s (%s)", signal_text(g->signal), strsignal(g->signal));
    if (g->signal == SIGSYS)
        fprintf(f, ": number %zu; they call functions of C and NX (doc/host-files.md)", (size_t)g->address);
    else if (memory && g->address < stack && g->address >= stack - (1 << 16))
        fprintf(f, ": its stack of %zu KB overflowed (stack_kb in the machine file)",
                (size_t)(n->sys->cfg->stack_bytes >> 10));
    else if (memory && g->address < 4096)
        fprintf(f, ": a null pointer");
    else if (owner && owner != n)
        fprintf(f, ": 0x%zx, in the memory of %s", (size_t)g->address, owner->name);
    else if (memory && is_behind(g->address, n->program + n->image_bytes))
        fprintf(f, ": 0x%zx, behind the end of its static data", (size_t)g->address);
    else if (memory && is_behind(g->address, n->heap_start + n->region->heap_bytes))
        fprintf(f, ": 0x%zx, behind the end of its heap", (size_t)g->address);
    else if (memory)
        fprintf(f, ": 0x%zx", (size_t)g->address);
    if (memory && n->failed_malloc)
        fprintf(f, "\n  its memory was exhausted: malloc could not give %zu bytes", n->failed_malloc);
}

/* Does the function at pc keep a frame? GCC gives none to a function that only computes; then the caller's
 * address is on top of the stack, and the frames do not show it. */
static bool has_frame(const struct node *n, uintptr_t pc)
{
    enum { PUSH_RBP = 0x55 };
    static const unsigned char ENDBR64[] = {0xf3, 0x0f, 0x1e, 0xfa};
    size_t start = node_image_function(n->file, pc - (uintptr_t)n->program);
    const unsigned char *code = (unsigned char *)n->program + start;
    return code[memcmp(code, ENDBR64, sizeof ENDBR64) ? 0 : sizeof ENDBR64] == PUSH_RBP;
}

char *crash_report(const struct node *n)
{
    const struct node_crash *g = n->crash;
    assert(g && g->depth > 0);
    char *text = NULL;
    size_t size;
    FILE *f = xchecked(open_memstream(&text, &size));
    fprintf(f, "%s crashed at %s%s, %s%s: ", n->name, n->call ? "" : "or shortly before ",
            virtual_time_moment(n->stats.ended_at).text, n->call ? "in " : "computing",
            n->call ? n->call : "");
    print_cause(f, n);
    if (g->in_library && !n->call) {
        const char *called = g->depth > 1 ? backtrace_called(n, g->frames[1]) : NULL;
        fprintf(f, "\n  in %s", called ? called : "a library function");
    }
    backtrace_print(f, n, "in", g->frames[0]);
    if (!g->in_library && !has_frame(n, g->frames[0]))
        backtrace_print(f, n, "called from", g->top - 1);
    for (int i = 1; i < g->depth; i++)
        backtrace_print(f, n, "called from", g->frames[i] - 1);
    fclose(f);
    return text;
}
