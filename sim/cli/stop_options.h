/* stop_options.h - where touchstone run --gdb NODE is to stop. */
#ifndef CLI_STOP_OPTIONS_H
#define CLI_STOP_OPTIONS_H
#include "cli/options.h"
#include "machine/debug_stop.h"

/* Takes the value of --gdb: "3", "host". */
void cli_take_stop(struct argp_state *state, struct debug_stop_options *stop, const char *node);
/* When all options are read: is there such a node? host: is there a host program? nodes: 0: not known. */
void cli_check_stop(struct argp_state *state, const struct debug_stop_options *stop, bool host,
                    uint32_t nodes);
#endif
