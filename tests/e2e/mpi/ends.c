/* How a program ends, by its argument. */
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static volatile long forever = 1;

static void quit_well(void)
{
    printf("%ld has ended\n", mynode());
}

int main(int argc, char *argv[])
{
    const char *how = argc > 1 ? argv[1] : "";
    char line[80];
    if (!strcmp(how, "killcube")) { /* node 1 kills the others, which compute or wait */
        printf("%ld\n", mynode());
        gsync();
        if (mynode() == 1)
            killcube(-1, -1);
        if (mynode() == 0)
            crecv(1, 0, 0);
        while (forever)
            ;
    } else if (!strcmp(how, "killproc")) {
        gsync();
        if (mynode() == 0)
            killproc(1, 0);
        while (mynode() == 1)
            ;
        printf("%ld lives\n", mynode());
    } else if (!strcmp(how, "returns")) {
        atexit(quit_well);
        return 7;
    } else if (!strcmp(how, "exits")) {
        if (mynode() == 1)
            exit(3);
        crecv(1, 0, 0); /* never comes */
    } else if (!strcmp(how, "crashes")) {
        if (mynode() == 2)
            *(volatile int *)8 = 1;
        gsync();
    } else if (!strcmp(how, "errs")) {
        printf("%ld here\n", mynode());
        gsync();
        if (mynode() == 2)
            csend(1, line, 80, 77, 0);
        while (forever)
            ;
    } else if (!strcmp(how, "reads")) {
        if (mynode() == 0 && fgets(line, sizeof line, stdin))
            printf("read %s", line);
    } else if (!strcmp(how, "loads")) {
        load("other", 0, 0);
    }
    return 0;
}
