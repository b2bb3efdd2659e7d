/* cache.c - reads a field twice, writes it, changes it, and reads it again: clocks of each, of 40 a us. */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

static double field[65536];
volatile double sink;

static double sum_of(int n)
{
    double sum = 0;
    for (int i = 0; i < n; i++)
        sum += field[i];
    return sum;
}

static void report(const char *what, double begin)
{
    printf("%s %.0f\n", what, (dclock() - begin) * 40e6);
}

int main(int argc, char **argv)
{
    int n = argc > 1 ? atoi(argv[1]) : 0;
    double begin;
    for (int pass = 1; pass <= 2; pass++) {
        begin = dclock();
        sink = sum_of(n);
        report(pass == 1 ? "first" : "again", begin);
    }
    begin = dclock();
    for (int i = 0; i < n; i++)
        field[i] = n;
    report("write", begin);
    begin = dclock();
    for (int i = 0; i < n; i++)
        field[i] += 1;
    report("change", begin);
    begin = dclock();
    sink = sum_of(n);
    report("last", begin);
    return 0;
}
