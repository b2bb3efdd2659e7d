/* run_program.h - switching to a node's program, and what follows when the program yields. */
#ifndef LP_RUN_PROGRAM_H
#define LP_RUN_PROGRAM_H
#include "lp/lp.h"

/* Lets the program run on the calling thread until it yields. */
void lp_run(struct lp *lp);
/* The same on the coordinator: afterwards a crash is scheduled, an offloaded program submitted. */
void lp_run_here(struct lp *lp);
/* The same, and loads ahead what the coming events need. */
void lp_run_on(struct lp *lp);
/* The program has crashed, in a call or computing: schedules the report, at the time of its clock. Messages
 * may put the report off as they put off a call. */
void lp_crash(struct lp *lp);
#endif
