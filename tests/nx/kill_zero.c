/* kill(0, 9) ends the whole program, on all nodes; that is no failure. What a node has printed until then is
 * not lost.
 * run: all
 */
#include <signal.h>
#include <nx.h>
#include <stdio.h>

int main(void)
{
    long never;
    gsync();
    if (mynode() == 0) {
        for (double since = dclock(); dclock() < since + 0.01;) /* all wait */
            ;
        printf("the end\n");
        fflush(stdout);
        kill(0, 9);
        printf("not reached\n");
    }
    crecv(1, &never, sizeof never);
    printf("nor this\n");
    return 1;
}
