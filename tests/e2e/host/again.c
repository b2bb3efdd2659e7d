/* again.c - host: loads programs again and again, on nodes whose programs have ended, hang, compute without end, or have
 * left messages behind. */
#include <stdio.h>
#include "cube.h"

enum { GO = 1, SAID, LEFT };

static void tell(const char *what)
{
    long value[2];
    crecv(SAID, value, sizeof value);
    printf("%s: node %ld says %ld\n", what, value[0], value[1]);
}

int main(void)
{
    long node, pid, status, one = 1, list[] = {1, 0};
    load("counts", 1, 5);
    printf("to a list: %ld\n", _gsendx(GO, &one, sizeof one, list, 1));
    printf("to one without a program: %ld\n", _gsendx(GO, &one, sizeof one, list, 2));
    tell("list");
    killcube(-1, -1);
    load("ends", -1, 0); /* -n gives the cube */
    for (int i = 0; i < numnodes(); i++) {
        waitone(-1, 0, &node, &pid, &status);
        printf("node %ld ended with %ld\n", node, status);
    }
    printf("nobody left: %ld\n", _waitone(-1, 0, &node, &pid, &status));

    load("counts", 1, 5); /* has a global variable that it counts up */
    csend(GO, &one, sizeof one, 1, 5);
    tell("first");
    csend(LEFT, &one, sizeof one, 1, 5); /* never received: killcube throws it away */
    killcube(-1, -1);
    load("counts", 1, 5);
    csend(GO, &one, sizeof one, 1, 5);
    tell("memory and messages are new");

    csend(LEFT, &one, sizeof one, 1, 5); /* killproc leaves the node's messages for the next program */
    killproc(1, 5);
    csend(GO, &one, sizeof one, 1, 5);
    load("counts", 1, 5);
    tell("memory is new");

    load("endless", 0, 0);
    load("posts", 2, 0);
    load("sends", 3,
         0); /* a long message to node 2, which is killed before it comes, and to node 1, which takes it */
    tell("sends");
    killcube(-1, -1);
    load("counts", -1, 0);
    for (int i = 0; i < numnodes(); i++)
        csend(GO, &one, sizeof one, i, 0);
    for (int i = 0; i < numnodes(); i++)
        tell("all again");
    printf("loaded twice: %ld\n", _load("counts", 3, 0));
    killcube(-1, -1);
    printf("no program: %ld\n", _load("nowhere/to_be_found", 3, 0));
    printf("no node: %ld\n", _load("counts", 4, 0));
    return 0;
}
