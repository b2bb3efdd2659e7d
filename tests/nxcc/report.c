/* report.c - linked with counter.c, makes any counted program report at its end, on stderr: the units that it
 * has spent; the sum over its functions, if the program has a profile and the sum differs; and the calls that
 * came before the end of the lookahead. BUDGET in the environment is the number of units between preemptions;
 * then the report tells their times, too. */
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
    int64_t spent = counter_spent();
    fprintf(stderr, "%lld\n", (long long)spent);
    if (counter.broken)
        fprintf(stderr, "%ld calls came before the end of the lookahead\n", counter.broken);
    if (nxc_image.bodies_begin != nxc_image.bodies_end && counter_profiled() != spent)
        fprintf(stderr, "but %lld by function\n", (long long)counter_profiled());
    if (getenv("BUDGET"))
        fprintf(stderr, "%ld preemptions, times %llx\n", counter.preemptions,
                (unsigned long long)counter.times);
}
