/* speedup.h - speed-up and speed per node of a study's points, against a baseline:
 *
 *     speedup          n0 T0 / T      T: the point's time_s; n0, T0: nodes and time_s of the baseline
 *     speed_per_node   speedup / nodes
 *
 * One baseline is common to all points: the point of the fewest nodes, and of several such points the one of
 * the least time. A list of texts chooses another (`baseline` in a study file, touchstone plot --baseline):
 *
 *     "AXIS=VALUE"     only points of that value may be the baseline
 *     "AXIS"           each value of the axis has a baseline of its own, as it must have where the values are
 *                      different problems
 */
#ifndef LAB_CHART_SPEEDUP_H
#define LAB_CHART_SPEEDUP_H
#include "lab/chart/record.h"

struct speedup;

/* Finds the baseline among the points that have nodes and time_s. said: the list of texts, ended by NULL, or
 * NULL. Memory grows with the number of baselines. NULL with *error malloc'd if the study has no such axis or
 * value, or a point cannot be read. */
struct speedup *speedup_find(const struct record_points *points, const char *const *said, char **error);
void speedup_free(struct speedup *s);

/* Sets the point's speedup and speed_per_node if both it and its baseline have nodes and time_s. A figure
 * that the point has already stays, unless anew. */
void speedup_add(const struct speedup *s, json_t *point, bool anew);

/* Names the baseline, malloc'd: "nodes 1, group 8", "the fewest nodes of each image"; "nodes 4, assumed
 * ideal" if it is no point of one node; "" without baseline. */
char *speedup_baseline(const struct speedup *s);

/* Sets the speeds of all points of a results.json that record_read() has read, and `baseline` in its header.
 * False with *error malloc'd. */
bool speedup_renew(struct record_points *points, const char *const *said, char **error);
#endif
