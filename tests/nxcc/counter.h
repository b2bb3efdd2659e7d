/* counter.h - the simulator's side of the counter, for tests that link counted objects into an ordinary
 * program. */
#ifndef COUNTER_H
#define COUNTER_H
#include <stdint.h>
#include "nx_api/contract/program_image.h"

extern struct nxc_image nxc_image;

struct counter {
    int64_t budget;        /* units between preemptions */
    void (*handler)(void); /* called at each preemption, unless NULL */
    int64_t spent;         /* units up to the last preemption */
    int64_t overshoot;     /* the most by which a poll came late */
    long preemptions;
    uint64_t times;    /* what was spent at each of them, in one number */
    int64_t lookahead; /* units that polls have said will be spent before the next call of served() */
    long broken;       /* calls of served() before that */
};

extern struct counter counter;

void counter_start(int64_t budget);
int64_t counter_spent(void);
/* A call that the simulator would serve. */
void served(void);
/* What all functions have spent since counter_start, by the paths of a program built with --profile. */
int64_t counter_profiled(void);
/* What one of them has, itself or in the library function called, if that is not NULL. */
int64_t counter_of(const char *function, const char *called);
/* What the line of the function has; what a path has by itself, "main;relax". */
int64_t counter_of_line(const char *function, int line);
int64_t counter_of_path(const char *path);
/* Is nobody's path entered that has not been left? */
int counter_at_root(void);
#endif
