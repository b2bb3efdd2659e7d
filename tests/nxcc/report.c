/* report.c - makes any counted program, linked with counter.c, say at its end what it spent: "UNITS PREEMPTIONS" on
 * stderr. BUDGET in the environment is the number of units between preemptions. */
#include <stdio.h>
#include <stdlib.h>
#include "counter.h"

__attribute__((constructor)) static void begin(void)
{
    const char *budget = getenv("BUDGET");
    counter_start(budget ? atoll(budget) : INT64_MAX / 2);
}

__attribute__((destructor)) static void end(void)
{
    fprintf(stderr, "%lld\n", (long long)counter_spent());
}
