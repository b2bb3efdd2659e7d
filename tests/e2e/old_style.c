/* old_style.c - a program of 1990: no prototypes, implicit int, old-style definitions, common variables, a
 * main that falls off its end. With old_style_part.c. */
/* clang-format off */
#include <cube.h>
#include <stdio.h>

int me, nodes;
char buffer[128];
double clock0;

static handler(type, count, node, pid)
{
    printf("node %d: type %d, %d bytes from %d\n", me, type, count, node);
}

main(argc, argv)
int argc;
char **argv;
{
    int i;
    me = mynode();
    nodes = numnodes();
    clock0 = dclock();
    if (me == 0) {
        for (i = 1; i < nodes; i++)
            give(i, i * 3);
    } else {
        take();
    }
    gsync();
    hrecv(20 + me, buffer, sizeof buffer, handler);
    gsync();
    csend(20 + (me + 1) % nodes, buffer, me, (me + 1) % nodes, mypid());
    gsync();
    if (dclock() < clock0)
        printf("node %d: wrong\n", me);
}
