/* work.h - computing, for the programs of this folder. */
#ifndef WORK_H
#define WORK_H

/* About so many microseconds of an i860 at 40 MHz. */
static inline void work(long micros)
{
    volatile long turns = micros * 22 / 5;

    while (turns > 0)
        turns--;
}

/* LATE: microseconds by which the program is late where its bad outcome begins; without it the program does
 * well in the usual run. */
#ifdef LATE
static inline void late(long times)
{
    work(times * LATE);
}
#else
static inline void late(long times)
{
    (void)times;
}
#endif
#endif
