/* sleep.c - pauses of a program, in which its handlers run as on a node: sleep and usleep of libnx.a take
 * precedence over the C library's, which nothing of ours interrupts. */
#include "nx_api/mpi/node.h"

/* Seconds since the program began at which the pause ends. */
static bool is_over(struct node *n, void *end)
{
    (void)n;
    return node_seconds() >= *(const double *)end;
}

static void pause_for(const char *call, double seconds)
{
    struct node *n = node_self();
    double end = node_seconds() + seconds;
    node_enter(n, call);
    node_wait(n, is_over, &end);
    node_leave(n);
}

unsigned node_sleep(unsigned seconds) NX_EXPORT("sleep");
unsigned node_sleep(unsigned seconds)
{
    pause_for("sleep", seconds);
    return 0;
}

int node_usleep(unsigned microseconds) NX_EXPORT("usleep");
int node_usleep(unsigned microseconds)
{
    pause_for("usleep", 1e-6 * microseconds);
    return 0;
}
