/* sleep.c - sleep and usleep of libnx.a, in which a program's handlers run as on a node. They precede the C
 * library's, in which no handler would run. Libraries call them, too: MPI sleeps while it starts, and no
 * handler may run then. */
#include "nx_api/mpi/sleep.h"
#include <errno.h>
#include <stdbool.h>
#include <time.h>
#include "nx_api/mpi/mpi_node.h"

/* The linker's: the bounds of the program's code, libnx.a included. */
extern const char __executable_start[], etext[];

static bool is_program(const void *caller)
{
    return (const char *)caller >= __executable_start && (const char *)caller < etext;
}

bool sleep_is_over(struct node *n, void *time)
{
    (void)n;
    return mpi_seconds() >= *(const double *)time;
}

static void pause_program(const char *call, double seconds)
{
    struct node *n = node_self();
    double end = mpi_seconds() + seconds;
    node_enter(n, call);
    node_wait(n, sleep_is_over, &end);
    node_leave(n);
}

static void pause_library(double seconds)
{
    struct timespec left = {(time_t)seconds, (long)((seconds - (double)(time_t)seconds) * 1e9)};
    while (nanosleep(&left, &left) && errno == EINTR)
        ;
}

static void pause_caller(const void *caller, const char *call, double seconds)
{
    if (is_program(caller))
        pause_program(call, seconds);
    else
        pause_library(seconds);
}

unsigned node_sleep(unsigned seconds) NX_EXPORT("sleep");
unsigned node_sleep(unsigned seconds)
{
    pause_caller(__builtin_return_address(0), "sleep", seconds);
    return 0;
}

int node_usleep(unsigned microseconds) NX_EXPORT("usleep");
int node_usleep(unsigned microseconds)
{
    pause_caller(__builtin_return_address(0), "usleep", 1e-6 * microseconds);
    return 0;
}
