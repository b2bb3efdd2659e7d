/* sensitivity.c - two nodes send each other a message, twenty in all, of as many bytes as asked for. Leaves a
 * file with the time, which another run must not overwrite; ends with an error if asked for no bytes. */
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv)
{
    static char text[4096];
    long bytes = argc > 1 ? atol(argv[1]) : 40, other = 1 - mynode();
    for (int i = 0; i < 10; i++) {
        if (mynode() == 0)
            csend(1, text, bytes, other, 0);
        crecv(1, text, bytes);
        if (mynode() == 1)
            csend(1, text, bytes, other, 0);
    }
    if (mynode() == 0) {
        FILE *f = fopen("took", "w");
        fprintf(f, "%.9f\n", dclock());
        fclose(f);
        puts(fgets(text, sizeof text, stdin) ? text : "no input");
    }
    if (!bytes)
        exit(5);
    return 0;
}
