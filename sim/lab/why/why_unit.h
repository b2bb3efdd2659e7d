/* why_unit.h - times as text, all of a report in one unit. */
#ifndef LAB_WHY_UNIT_H
#define LAB_WHY_UNIT_H
#include <stdio.h>
#include "kernel/vtime.h"

struct why_unit {
    const char *name; /* "s" */
    vtime ps;
};

/* A unit in which a run of that length reads well: s, ms or us. */
struct why_unit why_unit_for(vtime_sum length);

/* Room for a time, or a percentage, as text. */
struct why_text {
    char text[40];
};
/* "107.224 s" and "107.224": three digits behind the point; of a time of 1000 or more, "12494.7 s", one. */
struct why_text why_time(struct why_unit u, vtime_sum t);
struct why_text why_number(struct why_unit u, vtime_sum t);
/* The part of the whole, in percent: "99.9 %", "less than 0.1 %". */
struct why_text why_percent(vtime_sum part, vtime_sum whole);
/* How many times faster: "1.64"; "very many" if nothing is left. */
struct why_text why_faster(vtime_sum before, vtime_sum after);
#endif
