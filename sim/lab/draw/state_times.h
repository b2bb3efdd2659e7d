/* state_times.h - the times of each row's nodes in each activity, in each bin of time. The
 * utilisation count (one row of all nodes), the Gantt chart and Kiviat's diagram (one bin) are drawn from
 * it. */
#ifndef LAB_DRAW_STATE_TIMES_H
#define LAB_DRAW_STATE_TIMES_H
#include "lab/draw/node_rows.h"
#include "lab/draw/time_bins.h"

/* In the order in which pictures stack them. */
enum activity {
    ACTIVITY_COMPUTING,
    ACTIVITY_HANDLER, /* computing in a handler */
    ACTIVITY_SYSTEM,  /* the operating system works for a message */
    ACTIVITY_CALL,    /* the operating system works for the program's call */
    ACTIVITY_WAITING,
    ACTIVITIES /* the rest: without a program */
};

struct state_times {
    int32_t rows;
    struct time_bins bins;
    double *sums; /* picoseconds x nodes: [row][bin][activity] */
};

/* The activity of a piece of a node's time; ACTIVITIES of one without a program. */
enum activity activity_of(const struct trace_piece *p);
/* "computing", "waiting" ...; of ACTIVITIES "ended", or "no program" where a host loads the programs. */
const char *activity_name(const struct trace *t, enum activity a);

struct state_times state_times_make(const struct trace *t, const struct node_rows *r, struct time_bins bins);
void state_times_free(struct state_times *s);
static inline double *state_times_at(const struct state_times *s, int32_t row, uint32_t bin)
{
    return s->sums + ((size_t)row * s->bins.count + bin) * ACTIVITIES;
}
/* The sum over all rows, as a table of one row. */
struct state_times state_times_total(const struct state_times *s);
#endif
