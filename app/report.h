/* report.h - measurements of all nodes, summed up and printed. */
#ifndef REPORT_H
#define REPORT_H
#include "options.h"

/* Called by all nodes, after their last work; node 0 prints. start_s: dclock() at the start, on node 0. */
void report(const struct options *o, int is_host, double start_s);

#endif
