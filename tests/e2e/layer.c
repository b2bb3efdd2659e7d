/* layer.c - a program over a message layer, pass_*, that hides NX from it: node 1 waits for a second message
 * that node 0 does not send; with an argument, it asks for it for ever. */
#include <nx.h>

static long block[4];

__attribute__((noinline)) static long pass_recv(long *to)
{
    long id = irecv(0, to, sizeof *to);
    *to = 0; /* NX has it */
    msgwait(id);
    return infocount();
}

__attribute__((noinline)) static long pass_send(long *from, long to)
{
    csend(0, from, sizeof *from, to, 0);
    return infocount();
}

__attribute__((noinline)) static long pass_poll(void)
{
    while (!iprobe(0))
        ;
    return infocount();
}

__attribute__((noinline)) static long exchange(int polls)
{
    if (mynode() == 0)
        return pass_send(block, 1) + 1;
    pass_recv(block);
    return polls ? pass_poll() + 1 : pass_recv(block + 1) + 1;
}

int main(int argc, char **argv)
{
    (void)argv;
    return exchange(argc > 1) < 0;
}
