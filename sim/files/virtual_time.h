/* virtual_time.h - virtual times as people write them: 1.5s, 12ms, 3us, 40ns, 1234ps. */
#ifndef FILES_VIRTUAL_TIME_H
#define FILES_VIRTUAL_TIME_H
#include "kernel/vtime.h"

/* Reads a time, 0 or more, that text is from end to end; a number alone is in seconds. False, with *t
 * unchanged, if it is none. */
bool virtual_time_read(const char *text, vtime *t);
/* The time as virtual_time_read() reads it, exactly, in the largest unit in which it is whole: "500us".
 * Malloc'd. */
char *virtual_time_text(vtime t);

/* Times for people, in the unit that suits: s, ms, us or ns. */
struct time_text {
    char text[32];
};
/* A moment: all digits down to a nanosecond, of less than a microsecond to a picosecond: "29.456789 ms". */
struct time_text virtual_time_moment(vtime t);
/* A duration, of virtual or real time, in four digits, noughts at its end too: "6.613 ms", "30.10 s",
 * "12346 s"; or negative. 0 is "0 s". */
struct time_text duration_text(double seconds);
/* A duration that a user has given, in the digits that it has: "30 s", "1.5 ms". */
struct time_text limit_text(double seconds);
#endif
