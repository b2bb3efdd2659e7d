/* guarantee.h - the number of runs in the manner of PCT (timing/draw.h) that find a fault. Burckhardt et
 * al. (2010): if a fault needs d ordering constraints among n programs with k events in all, a run with
 * depth d finds it with probability 1 / (n k^(d-1)) at least; provided that the delays are long enough for
 * every order. */
#ifndef LAB_EXPLORE_GUARANTEE_H
#define LAB_EXPLORE_GUARANTEE_H
#include <stdint.h>

/* That probability. */
double guarantee_of_a_run(uint32_t programs, uint64_t events, uint32_t depth);
/* So many runs find such a fault with 95 % probability. */
double guarantee_runs(uint32_t programs, uint64_t events, uint32_t depth);
#endif
