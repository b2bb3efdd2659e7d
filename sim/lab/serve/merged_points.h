/* merged_points.h - a study's points and those that were added to it, as one. */
#ifndef LAB_SERVE_MERGED_POINTS_H
#define LAB_SERVE_MERGED_POINTS_H
#include <jansson.h>

/* The header { title, about, program, axes } with `points`, a list: the own ones, a list or an object of
 * which only points on the header's axes are taken, then the added ones, an object. An added point gets
 * speedup and speed_per_node from the study's point that it is to be compared with. A header of NULL is an
 * empty one. The caller owns the result; the points are copies. */
json_t *merged_points(const json_t *header, const json_t *own, const json_t *added);
#endif
