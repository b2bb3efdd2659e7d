/* farm.c - host: sends tasks to free nodes, one after the other, and collects the results. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cube.h"
#include "farm.h"

static double table[MOST];
static int pieces, done, handled;

static void progress(long type, long count, long node, long pid)
{
    (void)type, (void)pid;
    handled += count == 0 && node >= 0 && node < numnodes();
    hrecv(PROGRESS, NULL, 0, progress);
}

static void give(long node)
{
    struct piece p = {pieces < PIECES ? pieces : -1};
    pieces += pieces < PIECES;
    csend(WORK, &p, sizeof p, node, NODE_PID);
}

int main(int argc, char **argv)
{
    struct result r;
    setpid(HOST_PID);
    getcube("farm", argc > 1 ? argv[1] : "8", "", 0);
    printf("%ld nodes, dimension %ld, host is %ld, mynode %ld, pid %ld\n", numnodes(), nodedim(), myhost(),
           mynode(), mypid());
    hrecv(PROGRESS, NULL, 0, progress);
    load("farm_node", -1, NODE_PID);
    for (int i = 0; i < MOST; i++)
        table[i] = i;
    csend(TABLE, table, sizeof table, -1, NODE_PID); /* a long message to all */
    for (long i = 0; i < numnodes(); i++)
        give(i);
    double sum = 0;
    for (; done < PIECES; done++) {
        crecv(RESULT, &r, sizeof r);
        if (infopid() != NODE_PID || infonode() != r.node || infocount() != sizeof r)
            printf("a result of node %ld, pid %ld, %ld bytes?\n", infonode(), infopid(), infocount());
        sum += r.sum;
        give(r.node);
    }
    waitall(-1, NODE_PID);
    printf("%d pieces, sum %.0f, %d told of\n", done, sum, handled);
    struct cubeinfo info[10];
    long cubes = cubeinfo(info, 10, 0);
    printf("%ld cube, %s of %ld nodes\n", cubes, info[0].cubename, info[0].nodes);
    relcube("farm");
    printf("%ld cubes\n", cubeinfo(info, 10, 0));
    char line[80];
    if (fgets(line, sizeof line, stdin))
        printf("the host reads: %s", line);
    return 0;
}
