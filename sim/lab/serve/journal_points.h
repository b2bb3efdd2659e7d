/* journal_points.h - the points of a journal (lab/jobs/journal.h) that others write, read on as it grows.
 * Of a point that has several lines, the last counts. */
#ifndef LAB_SERVE_JOURNAL_POINTS_H
#define LAB_SERVE_JOURNAL_POINTS_H
#include <jansson.h>
#include <stddef.h>
#include <stdint.h>

struct journal_points {
    json_t *points;   /* flat points as in results.json, under texts that tell them apart */
    uint64_t read_to; /* complete lines end here */
    size_t since;     /* lines behind the byte that was given */
};

void journal_points_init(struct journal_points *j);
void journal_points_free(struct journal_points *j);
/* Reads what is new in the file, which may have shrunk; counts lines behind the byte `from` in since. fd -1:
 * there is no file. */
void journal_points_read(struct journal_points *j, int fd, uint64_t from);
/* The settings of an added point, a list, as one text: "system.call_us=5 cpu.clock_mhz=50". malloc'd. */
char *journal_points_settings(const json_t *set);
#endif
