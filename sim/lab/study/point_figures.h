/* point_figures.h - what a run came to as one flat object: key, number or text.
 *
 * The figures that the program printed; what the simulator said of the run, members of its groups as GROUP.MEMBER;
 * idle_pct, the idle part of all nodes' time, percent; memory_peak_bytes of the node that had most; and of its nodes the means, of those that ran handlers (handlers.KEY) and of the others (others.KEY):
 *   nodes                      how many
 *   busy_s, idle_s, system_s   where their time went
 *   waits.CALL_s               idle in that call; in waits for messages of the program's own (waits.message_s) or of
 *                              operations of all nodes (waits.global_s)
 */
#ifndef LAB_STUDY_POINT_FIGURES_H
#define LAB_STUDY_POINT_FIGURES_H
#include "lab/jobs/outcome.h"

json_t *point_figures_of(const struct outcome *o);
#endif
