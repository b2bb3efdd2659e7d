/* trace_options.c - see trace_options.h. */
#include "cli/trace_options.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

enum { FROM = CLI_KEY + 0x8000, TO, NODES };

/* Passes over "host" at *at, and what separates it from the next. */
static bool pass_host(const char **at)
{
    size_t length = strcspn(*at, ",");
    if (length != 4 || strncmp(*at, "host", 4) || ((*at)[4] && !(*at)[5]))
        return false;
    *at += (*at)[4] ? 5 : 4;
    return true;
}

/* Reads "7" or "3-7" at *at, and what separates it from the next. */
static bool range(const char **at, uint32_t *first, uint32_t *last)
{
    char *end;
    if (**at < '0' || **at > '9')
        return false;
    unsigned long a = strtoul(*at, &end, 10), b = a;
    if (*end == '-' && end[1] >= '0' && end[1] <= '9')
        b = strtoul(end + 1, &end, 10);
    if ((*end && *end != ',') || (*end == ',' && !end[1]) || a > b || b >= UINT32_C(1) << 20)
        return false;
    *first = (uint32_t)a, *last = (uint32_t)b;
    *at = *end ? end + 1 : end;
    return true;
}

void cli_node_list(struct argp_state *state, const char *option, const char *text, bool **nodes,
                   uint32_t *count, bool *host)
{
    const char *at = text;
    *nodes = xcalloc(1, sizeof **nodes), *count = 0;
    for (uint32_t first, last; *at || at == text;) {
        if (host && pass_host(&at)) {
            *host = true;
            continue;
        }
        if (!range(&at, &first, &last)) {
            argp_error(state, "%s takes nodes such as 0-7,12%s, not '%s'", option, host ? ",host" : "", text);
            return;
        }
        if (last >= *count) {
            *nodes = xreallocarray(*nodes, last + 1, sizeof **nodes);
            memset(*nodes + *count, 0, (last + 1 - *count) * sizeof **nodes);
            *count = last + 1;
        }
        memset(*nodes + first, true, last + 1 - first);
    }
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct trace_selection *s = state->input;
    bool *nodes;
    if (key == FROM) {
        s->from = cli_virtual_time(state, "--from", arg);
    } else if (key == TO) {
        s->to = cli_later_time(state, "--to", arg);
    } else if (key == NODES) {
        cli_node_list(state, "--nodes", arg, &nodes, &s->node_count, &s->host);
        s->nodes = nodes;
    } else if (key == ARGP_KEY_END) {
        if (s->to && s->to <= s->from)
            argp_error(state, "--to must be later than --from");
    } else {
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

static const struct argp_option OPTIONS[] = {
    {"from", FROM, "TIME", 0, "Only what overlaps the virtual time from TIME on: 1.5s, 12ms, 3us", 0},
    {"to", TO, "TIME", 0, "Only up to TIME", 0},
    {"nodes", NODES, "LIST", 0, "Only nodes such as 0-7,12,host, and messages with an end there", 0},
    {0}};
const struct argp CLI_TRACE_SELECTION = {OPTIONS, parse, NULL, NULL, NULL, NULL, NULL};
