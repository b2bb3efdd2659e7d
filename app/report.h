/* report.h - measurements of all nodes, summed up and printed. */
#ifndef REPORT_H
#define REPORT_H
#include "options.h"

/* Called by all nodes when the program has ended for them; node 0 prints. start_s: its time of the start. */
void report(const struct options *o, int is_host, double start_s);

#endif
