/* cache.c - reads a field twice, then writes it: clocks of each, of 40 a microsecond. */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

static double field[65536];
volatile double sink;

static void report(const char *what, double begin)
{
    printf("%s %.0f\n", what, (dclock() - begin) * 40e6);
}

int main(int argc, char **argv)
{
    int n = argc > 1 ? atoi(argv[1]) : 0;
    double begin;
    for (int pass = 1; pass <= 2; pass++) {
        double sum = 0;
        begin = dclock();
        for (int i = 0; i < n; i++)
            sum += field[i];
        report(pass == 1 ? "first" : "again", begin);
        sink = sum;
    }
    begin = dclock();
    for (int i = 0; i < n; i++)
        field[i] = n;
    report("write", begin);
    return 0;
}
