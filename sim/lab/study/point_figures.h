/* point_figures.h - the result of a run as one flat object: key, number or text. It has
 *   - the figures that the program printed,
 *   - the simulator's figures of the run, members of its groups as GROUP.MEMBER,
 *   - idle_pct, the idle part of all nodes' time, percent,
 *   - memory_peak_bytes of the node that used most,
 *   - means over the nodes that ran handlers (handlers.KEY) and over the others (others.KEY), with the keys
 *       nodes                      how many nodes
 *       busy_s, idle_s, system_s   where their time went
 *       waits.CALL_s               idle in that call, or in waits for messages: waits.message_s for the
 *                                  program's own types, waits.global_s for global operations
 */
#ifndef LAB_STUDY_POINT_FIGURES_H
#define LAB_STUDY_POINT_FIGURES_H
#include "lab/jobs/outcome.h"

/* The caller owns the object. */
json_t *point_figures_of(const struct outcome *o);
#endif
