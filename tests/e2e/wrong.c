/* wrong.c - makes a call with a wrong argument, which ends the process with a message. The argument of the
 * program names the call. */
#include <errno.h>
#include <signal.h>
#include <nx.h>
#include <stdio.h>
#include <string.h>

int main(int argc, char *argv[])
{
    static char buf[10], all[10];
    const char *which = argc > 1 ? argv[1] : "";
    long total;
    if (mynode() != numnodes() - 1 && strcmp(which, "gcol") != 0)
        return 0;
    if (strcmp(which, "csend") == 0)
        csend(-3, buf, 1, 0, 0);
    if (strcmp(which, "gsendx") == 0)
        gsendx(1, buf, 1, (const long[]){0, 99}, 2);
    if (strcmp(which, "hrecv") == 0) {
        hrecv(1, buf, 4, (void (*)(long, long, long, long))main);
        csend(1, buf, 5, mynode(), 0);
        gsync();
    }
    if (strcmp(which, "msgignore") == 0) {
        msgignore(irecv(1, buf, 4));
        csend(1, buf, 5, mynode(), 0);
        while (dclock() < 1)
            ;
    }
    if (strcmp(which, "gcol") == 0)
        gcol(buf, 6, all, 10, &total);
    if (strcmp(which, "nxperror") == 0) {
        _csend(1, buf, 1, 99, 0);
        nxperror("sending");
        errno = EQMID;
        nxperror("else");
        perror("and");
    }
    if (strcmp(which, "kill") == 0)
        kill(0, 9);
    return 0;
}
