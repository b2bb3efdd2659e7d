/* count.h - the counting pass, for the plugin to register. */
#ifndef NXCC_COUNT_H
#define NXCC_COUNT_H
#include "base/gcc.h"
extern bool count_in_memory; /* never keep the counter in a register: polled, for tests */

opt_pass *count_make_pass();
/* Is the counter kept in a register? Not where control comes over edges at which none is safe. */
bool count_is_in_register(function *fun);
/* The counter's variable, and: may a statement read or change it? Of the function that has been counted. */
tree count_counter();
bool count_needs_counter(gimple *stmt);
#endif
