/* guarantee.c - see guarantee.h. */
#include "lab/explore/guarantee.h"
#include <math.h>

double guarantee_of_a_run(uint32_t programs, uint64_t events, uint32_t depth)
{
    return 1 / ((double)programs * pow(events ? (double)events : 1, depth - 1));
}

double guarantee_runs(uint32_t programs, uint64_t events, uint32_t depth)
{
    double missed = log1p(-guarantee_of_a_run(programs, events, depth));
    return missed < 0 && isfinite(missed) ? ceil(log(0.05) / missed) : 1;
}
