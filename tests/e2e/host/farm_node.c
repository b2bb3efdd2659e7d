/* farm_node.c - node: computes the tasks that the host of farm.c sends, until no task is left. */
#include <stdio.h>
#include <stdlib.h>
#include "cube.h"
#include "farm.h"

int main(int argc, char **argv)
{
    static double table[MOST];
    struct piece p;
    if (argc != 1 || !argv[0] || mypid() != NODE_PID)
        printf("node %ld: %d arguments, pid %ld\n", mynode(), argc, mypid());
    crecv(TABLE, table, sizeof table);
    if (infonode() != myhost() || infopid() != HOST_PID || infonode() != numnodes())
        printf("node %ld: the table is from %ld, pid %ld\n", mynode(), infonode(), infopid());
    if (mynode() == 0)
        csend(AROUND, table, 16, -1, NODE_PID); /* to all other nodes, not to the host */
    else
        crecv(AROUND, table, 16);
    gsync();
    for (;;) {
        crecvx(WORK, &p, sizeof p, myhost(), HOST_PID, NULL);
        if (p.number < 0)
            break;
        csend(PROGRESS, NULL, 0, myhost(), HOST_PID);
        struct result r = {mynode(), 0};
        for (int i = (int)p.number; i < MOST; i += PIECES)
            r.sum += table[i];
        csend(RESULT, &r, sizeof r, myhost(), HOST_PID);
    }
    if (iprobe(-1))
        printf("node %ld has a message of type %ld\n", mynode(), infotype());
    return 0;
}
