/* trace_options.h - what the commands that make and read traces share: an interval of virtual time, and
 * nodes. */
#ifndef CLI_TRACE_OPTIONS_H
#define CLI_TRACE_OPTIONS_H
#include "cli/options.h"
#include "kernel/vtime.h"
#include "lab/trace/trace_model.h"

/* Nodes such as 0-7,12. *nodes (malloc'd) is by number, of *count. *host: does the list name the host? host
 * NULL: it may not. */
void cli_node_list(struct argp_state *state, const char *option, const char *text, bool **nodes,
                   uint32_t *count, bool *host);

/* The options --from, --to and --nodes of what reads traces; input: struct trace_selection *, whose nodes
 * the caller frees. */
extern const struct argp CLI_TRACE_SELECTION;
#endif
