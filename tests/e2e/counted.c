/* counted.c - writes a line to the host's file runs.log in each run, then computes for a while. -crash N:
 * crashes on N nodes; -endless 1: never ends. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx.h"

static long option(int argc, char **argv, const char *name)
{
    for (int i = 1; i + 1 < argc; i++)
        if (strcmp(argv[i], name) == 0)
            return atol(argv[i + 1]);
    return 0;
}

int main(int argc, char **argv)
{
    volatile double x = 1;
    long steps = option(argc, argv, "-steps");
    if (mynode() == 0 && option(argc, argv, "-log")) {
        FILE *log = fopen("runs.log", "a");
        fprintf(log, "%ld %ld\n", numnodes(), steps);
        fclose(log);
    }
    if (mynode() == 0 && option(argc, argv, "-crash") == numnodes())
        abort();
    while (option(argc, argv, "-endless"))
        x += 1;
    for (long i = 0; i < 100000 * steps; i++)
        x = x * 0.5 + 1;
    for (long i = 0; i < 100000 * option(argc, argv, "-spin"); i++)
        x = x * 0.5 + 1;
    if (mynode() == 0)
        printf("x %g\ntotal_s %.9f\n", x, dclock());
    return 0;
}
