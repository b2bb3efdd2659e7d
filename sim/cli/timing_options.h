/* timing_options.h - the options of touchstone run about other timings than the machine's usual. */
#ifndef CLI_TIMING_OPTIONS_H
#define CLI_TIMING_OPTIONS_H
#include "cli/options.h"
#include "timing/draw.h"

struct timing_arguments {
    bool drawn;       /* --timing */
    struct draw draw; /* if so */
    const char *replay, *record;
    vtime until; /* 0: to the end */
};

/* --timing, --replay, --record and --until; input: struct timing_arguments *. */
extern const struct argp CLI_TIMING;
#endif
