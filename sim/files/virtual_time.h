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
#endif
