/* signals.c - what a process reports when it crashes, or on SIGUSR1, which mpirun forwards to all processes.
 * Only functions that are safe in a signal handler are used, so printf is not. */
#include "nx_api/mpi/signals.h"
#include <errno.h>
#include <signal.h>
#include <stdbool.h>
#include <string.h>
#include <ucontext.h>
#include <unistd.h>
#include "nx_api/mpi/mpi_node.h"
#include "nx_api/mpi/order_record.h"
#include "nx_api/mpi/safe_text.h"
#include "nx_api/mpi/where.h"

static struct safe_text text;

/* "nx: node 3: " and what, and the call it is in. */
static void append_state(struct safe_text *t, const char *what)
{
    const struct node *n = node_self();
    safe_append(t, "nx: node ");
    safe_append_number(t, n->id);
    safe_append(t, ": ");
    safe_append(t, what);
    if (n->over) {
        safe_append(t, " after its program's end");
    } else if (n->call.name) {
        safe_append(t, " in ");
        safe_append(t, n->call.name);
    } else {
        safe_append(t, " computing");
    }
    if (!n->over && n->call.name && n->call.has_type) {
        safe_append(t, ", of type or id ");
        safe_append_number(t, n->call.type);
    }
    if (n->in_handler)
        safe_append(t, ", in a handler");
}

static const char *name_of(int sig)
{
    return sig == SIGSEGV   ? "crashed (segmentation fault)"
           : sig == SIGFPE  ? "crashed (arithmetic error)"
           : sig == SIGBUS  ? "crashed (bus error)"
           : sig == SIGABRT ? "crashed (abort was called)"
                            : "crashed (illegal instruction)";
}

/* What the address says that was used. */
static const char *cause_of(const siginfo_t *info, const ucontext_t *context)
{
    enum { PAGE = 4096, FRAME = 1 << 16 };
    uintptr_t address = (uintptr_t)info->si_addr, stack = (uintptr_t)context->uc_mcontext.gregs[REG_RSP];
    if (info->si_signo != SIGSEGV || info->si_code <= 0)
        return "";
    return address < PAGE                        ? ": a null pointer"
           : address - stack + FRAME < 2 * FRAME ? ": the stack is full (ulimit -s)"
                                                 : "";
}

/* The first line is written before anything else is tried. A crash in here ends the process at once. */
static void crashed(int sig, siginfo_t *info, void *context)
{
    static volatile sig_atomic_t again;
    signal(sig, SIG_DFL);
    if (again++) {
        raise(sig);
        return;
    }
    append_state(&text, name_of(sig));
    safe_append(&text, cause_of(info, context));
    safe_append(&text, "\n");
    safe_write(&text);
    record_rescue();
    where_append(&text, context);
    safe_write(&text);
    raise(sig);
}

static void asked(int sig, siginfo_t *info, void *context)
{
    int saved = errno;
    (void)sig, (void)info;
    append_state(&text, "is");
    safe_append(&text, "\n");
    where_append(&text, context);
    safe_write(&text);
    errno = saved;
}

/* mpirun ends a process so when another has crashed. */
static void told_to_end(int sig)
{
    record_rescue();
    signal(sig, SIG_DFL);
    raise(sig);
}

/* A stack of its own, for reports of programs that have used up theirs. */
static void make_stack(void)
{
    static char space[1 << 17];
    sigaltstack(&(stack_t){.ss_sp = space, .ss_size = sizeof space}, NULL);
}

void signals_begin(void)
{
    static const int crashes[] = {SIGSEGV, SIGFPE, SIGBUS, SIGILL, SIGABRT};
    where_begin();
    make_stack();
    for (size_t i = 0; i < sizeof crashes / sizeof *crashes; i++)
        sigaction(
            crashes[i],
            &(struct sigaction){.sa_sigaction = crashed, .sa_flags = SA_NODEFER | SA_SIGINFO | SA_ONSTACK},
            NULL);
    sigaction(SIGTERM, &(struct sigaction){.sa_handler = told_to_end, .sa_flags = SA_NODEFER}, NULL);
    sigaction(SIGUSR1, &(struct sigaction){.sa_sigaction = asked, .sa_flags = SA_RESTART | SA_SIGINFO}, NULL);
}
