/* Processes: their numbers, waiting for others' ends, and what the Paragon's starting calls answer.
 * run: -m ipsc860 -n 3
 * run: -m delta -n 3
 */
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>

static void paragon(int argc, char *argv[])
{
    nx_nodes_t list;
    unsigned long n;
    long rows, columns;
    printf("nx_initve %ld, nx_nfork %ld\n", nx_initve("", 0, "", &argc, argv), nx_nfork(0, -1, 0, 0));
    nx_app_nodes(0, &list, &n);
    nx_app_rect(&rows, &columns);
    printf("%lu nodes, the last is %ld; rectangle of %ld\n", n, list[n - 1], rows * columns);
    free(list);
    printf("nx_load %ld, ", nx_load(0, -1, 0, 0, "other"));
    printf("%s\n", errno == ENOSYS ? "ENOSYS" : "?");
    printf("nx_waitall %ld\n", nx_waitall());
}

int main(int argc, char *argv[])
{
    long node = -1, pid = -1, status = -1;
    setpid(10 * mynode());
    if (mynode() == 1) {
        crecv(1, 0, 0);
        return 7; /* falls off its end with a value: no error */
    }
    if (mynode() == 2) {
        crecv(2, 0, 0); /* never comes: node 0 ends this one */
        return 0;
    }
    paragon(argc, argv);
    led(1);
    csend(1, 0, 0, 1, 0);
    waitone(-1, -1, &node, &pid, &status);
    printf("node %ld, pid %ld ended with %ld\n", node, pid, status);
    killproc(2, 0);
    waitall(-1, -1);
    printf("all have ended; once more: %ld\n", _waitone(-1, -1, &node, &pid, &status));
    return 0;
}
