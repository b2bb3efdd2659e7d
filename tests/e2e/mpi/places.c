/* places.c - each node writes where it runs into a file in /cfs, at its place; node 0 reads all. Then node 0 takes messages
 * in the order they come, or, by an argument: "waits": all wait for ever; "works": all work until they are ended. */
#include <nx.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { BYTES = 16 };

int main(int argc, char **argv)
{
    const char *how = argc > 1 ? argv[1] : "";
    static char much[1 << 16];
    char line[BYTES + 1] = "";
    volatile long forever = 1;
    int fd = gopen("/cfs/places", O_RDWR | O_CREAT, M_RECORD, 0666);
    gethostname(line, sizeof line - 1);
    cwrite(fd, line, BYTES);
    close(fd);
    gsync();
    if (mynode() == 0) {
        fd = open("/cfs/places", O_RDONLY);
        for (long i = 0; i < numnodes() && read(fd, line, BYTES) == BYTES; i++)
            printf("%s%s", line, i + 1 < numnodes() ? " " : "\n");
        close(fd);
        fflush(stdout);
    }
    if (!strcmp(how, "waits"))
        crecv(7, line, BYTES);
    gsync();
    while (!strcmp(how, "works") && forever)
        ;
    for (long i = 1; i < numnodes() && mynode() == 0; i++) {
        crecv(8, much, sizeof much);
        printf("%ld%s", infonode(), i + 1 < numnodes() ? " " : "\n");
    }
    if (mynode() != 0)
        csend(8, much, sizeof much, 0, 0);
    return 0;
}
