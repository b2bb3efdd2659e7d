/* Calls that send nothing: microseconds each, of the program and the system together. Some enter the node's
 * kernel, others stay in the library. */
#include <sys/time.h>
#include <unistd.h>
#include "bench.h"

enum { TIMES = 100, TYPE = 1, NEVER = 2 };

static char buf[8];

static void handler(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
}

static void mask(void)
{
    masktrap(0);
}

static void post_handler(void)
{
    hrecv(NEVER, buf, sizeof buf, handler);
}

static void give_way(void)
{
    flick();
}

static void look(void)
{
    iprobe(TYPE);
}

static void read_clock(void)
{
    dclock();
}

static void ask_number(void)
{
    mynode();
}

static void ask_unix_clock(void)
{
    struct timeval now;
    gettimeofday(&now, NULL);
}

static void ask_unix_number(void)
{
    getpid();
}

static void measure(const char *name, void (*call)(void))
{
    double begin = now_us();
    for (int i = 0; i < TIMES; i++)
        call();
    figure(name, (now_us() - begin) / TIMES);
}

int main(void)
{
    measure("masktrap_us", mask);
    measure("flick_us", give_way);
    measure("iprobe_us", look);
    measure("dclock_us", read_clock);
    measure("mynode_us", ask_number);
    measure("gettimeofday_us", ask_unix_clock);
    measure("getpid_us", ask_unix_number);
    measure("hrecv_us", post_handler);
    return 0;
}
