/* crashes.c - node 1 crashes, or makes an error, as its argument says. */
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char *volatile nowhere;
static volatile long forever = 1;
static volatile int result;
static void (*volatile none)(void);

__attribute__((noinline)) static long deep(long n)
{
    volatile char space[4000];
    space[n % 4000] = 1;
    return n < 0 ? 0 : deep(n + 1) + space[3];
}

__attribute__((noinline)) static void show(void)
{
    printf("%d\n", (int)strlen(nowhere));
}

__attribute__((noinline)) static int read_it(void)
{
    return *nowhere + 1;
}

__attribute__((noinline)) static int ask_for_it(void)
{
    return read_it() + 1;
}

__attribute__((noinline)) static void send_it(int node)
{
    csend(1, 0, 0, node, 0);
}

static void on_news(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
    result = ask_for_it();
}

/* Where it is interrupted: in its loop. */
static void wait_for_handler(char *buffer, long bytes)
{
    hrecv(5, buffer, bytes, on_news);
    csend(2, 0, 0, 0, 0);
    while (forever)
        ;
}

static void crash(const char *how)
{
    char buffer[8];
    if (!strcmp(how, "plain"))
        result = 1 + ask_for_it();
    else if (!strcmp(how, "library"))
        show();
    else if (!strcmp(how, "stack"))
        result = deep(1) > 0;
    else if (!strcmp(how, "pointer"))
        none();
    else if (!strcmp(how, "abort"))
        abort();
    else if (!strcmp(how, "buffer"))
        csend(1, (void *)8, 800, 0, 0);
    else if (!strcmp(how, "handler"))
        wait_for_handler(buffer, sizeof buffer);
    else if (!strcmp(how, "short"))
        wait_for_handler(buffer, 4);
    else if (!strcmp(how, "node"))
        send_it(77);
}

int main(int argc, char **argv)
{
    const char *how = argc > 1 ? argv[1] : "";
    char buffer[8] = "";
    if (mynode() == 1)
        crash(how);
    if (!strcmp(how, "handler") || !strcmp(how, "short")) {
        crecv(2, 0, 0);
        csend(5, buffer, sizeof buffer, 1, 0);
    }
    crecv(1, buffer, sizeof buffer);
    return 0;
}
