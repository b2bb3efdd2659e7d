/* count.h - the counting pass, for the plugin to register. */
#ifndef NXCC_COUNT_H
#define NXCC_COUNT_H
extern bool count_in_memory; /* never keep the counter in a register: polled, for tests */

opt_pass *count_make_pass();
#endif
