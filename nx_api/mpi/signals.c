/* signals.c - what a process reports when it crashes, or on SIGUSR1, which mpirun forwards to all processes.
 * Only functions that are safe in a signal handler are used, so printf is not. */
#include "nx_api/mpi/signals.h"
#include <errno.h>
#include <signal.h>
#include <string.h>
#include <unistd.h>
#include "nx_api/mpi/mpi_node.h"
#include "nx_api/mpi/order_record.h"

struct text {
    char bytes[200];
    size_t count;
};

static void append(struct text *t, const char *s)
{
    while (*s && t->count < sizeof t->bytes)
        t->bytes[t->count++] = *s++;
}

static void append_number(struct text *t, long number)
{
    char digits[24], *p = digits + sizeof digits - 1;
    unsigned long rest = number < 0 ? -(unsigned long)number : (unsigned long)number;
    *p = '\0';
    do
        *--p = (char)('0' + rest % 10);
    while ((rest /= 10) > 0);
    if (number < 0)
        *--p = '-';
    append(t, p);
}

/* "nx: node 3: " and what, and the call it is in. */
static void say(const char *what)
{
    struct text t = {.count = 0};
    const struct node *n = node_self();
    append(&t, "nx: node ");
    append_number(&t, n->id);
    append(&t, ": ");
    append(&t, what);
    if (n->over) {
        append(&t, " after its program's end");
    } else if (n->call) {
        append(&t, " in ");
        append(&t, n->call);
    } else {
        append(&t, " computing");
    }
    if (!n->over && n->call && n->call_has_type) {
        append(&t, ", of type or id ");
        append_number(&t, n->call_type);
    }
    append(&t, n->in_handler ? ", in a handler\n" : "\n");
    if (write(2, t.bytes, t.count) < 0)
        return;
}

static void crashed(int sig)
{
    say(sig == SIGSEGV  ? "crashed (segmentation fault)"
        : sig == SIGFPE ? "crashed (arithmetic error)"
        : sig == SIGBUS ? "crashed (bus error)"
                        : "crashed (illegal instruction)");
    record_rescue();
    signal(sig, SIG_DFL);
    raise(sig);
}

static void asked(int sig)
{
    int saved = errno;
    (void)sig;
    say("is");
    errno = saved;
}

/* mpirun ends a process so when another has crashed. */
static void told_to_end(int sig)
{
    record_rescue();
    signal(sig, SIG_DFL);
    raise(sig);
}

void signals_begin(void)
{
    static const int crashes[] = {SIGSEGV, SIGFPE, SIGBUS, SIGILL};
    for (size_t i = 0; i < sizeof crashes / sizeof *crashes; i++)
        sigaction(crashes[i], &(struct sigaction){.sa_handler = crashed, .sa_flags = SA_NODEFER}, NULL);
    static const int ends[] = {SIGTERM, SIGABRT};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++)
        sigaction(ends[i], &(struct sigaction){.sa_handler = told_to_end, .sa_flags = SA_NODEFER}, NULL);
    sigaction(SIGUSR1, &(struct sigaction){.sa_handler = asked, .sa_flags = SA_RESTART}, NULL);
}
