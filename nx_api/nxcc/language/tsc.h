/* tsc.h - the processor's counter of clocks, for programs that read it by its instruction, rdtsc: FFTW, for
 * example. That would be this computer's time, other in each run. The pass makes each such instruction, and
 * GCC's functions for it, read the ticks of the node's clock instead, as hwclock() gives them. */
#ifndef NXCC_TSC_H
#define NXCC_TSC_H
#include "base/gcc.h"

opt_pass *tsc_make_pass();
#endif
