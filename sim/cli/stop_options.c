/* stop_options.c - see stop_options.h. */
#include "cli/stop_options.h"
#include <string.h>

void cli_take_stop(struct argp_state *state, struct debug_stop_options *stop, const char *node)
{
    stop->wanted = true;
    stop->host = strcmp(node, "host") == 0;
    stop->node = 0;
    if (!stop->host && strcmp(node, "0") && !cli_is_whole(node, UINT32_MAX, &stop->node))
        argp_error(state, "--gdb takes a node's number, from 0 up, or 'host', not '%s'", node);
}

void cli_check_stop(struct argp_state *state, const struct debug_stop_options *stop, bool host,
                    uint32_t nodes)
{
    if (stop->time && !stop->wanted)
        argp_error(state, "--at needs --gdb NODE");
    if (stop->host && !host)
        argp_error(state, "--gdb host: there is no host program (--host)");
    if (stop->wanted && !stop->host && nodes && stop->node >= nodes)
        argp_error(state, "--gdb %u: nodes are 0 to %u", stop->node, nodes - 1);
}
