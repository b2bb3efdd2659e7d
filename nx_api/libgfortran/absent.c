/* absent.c - parts of GNU Fortran's library that a node does not have: threads for asynchronous I/O
 * (async.c), signals, and the host processor's instructions beyond plain x86-64;
 * and how the library is ended. */
#include <signal.h>
#include <stdlib.h>
#include "libgfortran.h"

/* --- asynchronous I/O: OPEN asks for it, and gets a unit without; the rest is never reached --- */

#define NEVER(name)                                                                                          \
    void _gfortrani_##name(void);                                                                            \
    void _gfortrani_##name(void)                                                                             \
    {                                                                                                        \
        nx_die("asynchronous I/O of the Fortran library: a node has no threads", NULL);                      \
    }

void _gfortrani_init_async_unit(void *unit);
void _gfortrani_init_async_unit(void *unit)
{
    (void)unit; /* as it is: without a thread */
}

NEVER(async_close)
NEVER(async_wait)
NEVER(async_wait_id)
NEVER(collect_async_errors)
NEVER(enqueue_close)
NEVER(enqueue_data_transfer_init)
NEVER(enqueue_done)
NEVER(enqueue_done_id)
NEVER(enqueue_transfer)

/* --- signals: its own handlers are for faults, which no handler is told of; nxcc.mk renames its calls --- */

sighandler_t nx_no_signal(int number, sighandler_t handler);
sighandler_t nx_no_signal(int number, sighandler_t handler)
{
    (void)number, (void)handler;
    return SIG_DFL;
}

int nx_no_sigaction(int number, const struct sigaction *to, struct sigaction *before);
int nx_no_sigaction(int number, const struct sigaction *to, struct sigaction *before)
{
    (void)number, (void)to;
    if (before)
        *before = (struct sigaction){.sa_handler = SIG_DFL};
    return 0;
}

/* --- libquadmath has REAL(16) in the formats of C's printf, too, where it can --- */

#define NO_FORMAT(name)                                                                                      \
    int register_printf_##name(void);                                                                        \
    int register_printf_##name(void)                                                                         \
    {                                                                                                        \
        return -1;                                                                                           \
    }
NO_FORMAT(modifier)
NO_FORMAT(specifier)
NO_FORMAT(type)

/* The sign that libquadmath's logarithm of the gamma function sets, too; of C's if the program calls that. */
extern int signgam __attribute__((weak));
int signgam;

/* --- no more than x86-64 has always had: MATMUL's variants would differ in their last bits --- */

/* What libgcc keeps about the processor, here that nothing is known of it. */
__attribute__((visibility("hidden"))) struct {
    unsigned vendor, type, subtype, features[1];
} __cpu_model;
__attribute__((visibility("hidden"))) unsigned __cpu_features2[4];

/* --- the beginning and the end --- */

/* The object with the library's own constructor and destructor is linked if something in it is called;
 * GNU's error.c would. With a main() in C nothing else does. The destructor closes units at a program's end,
 * however it comes to it: STOP, END, exit. */
__attribute__((constructor)) static void begin(void)
{
    _gfortrani_stupid_function_name_for_static_linking();
}
