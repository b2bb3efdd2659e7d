/* whereabouts.c - see whereabouts.h. */
#include "machine/whereabouts.h"
#include <stdio.h>
#include "guest/trace.h"
#include "kernel/xalloc.h"
#include "lp/clock.h"

/* The source line in which a node's program is; NULL if it is not known. At a limit of virtual time, a
 * computing program's line is that of its last slice boundary: the program may have computed past the limit
 * before it was known that the system takes time from it, and the report must be equal in every run. */
static const char *line_of(const struct node *n, struct trace_lines *lines)
{
    if (n->call)
        return n->lp.state == LP_BLOCKED || n->call_since == VT_NEVER ? trace_line(lines, n) : NULL;
    if (n->sys->schedule.stop == STOP_VIRTUAL_TIME)
        return trace_line_at(lines, n, clock_last_place(&n->lp));
    return n->at_poll ? trace_line(lines, n) : NULL;
}

static void describe_waiting(FILE *f, const struct node *n, struct trace_lines *lines)
{
    fprintf(f, "\n  %s: ", n->name);
    if (n->end == NODE_NOT_LOADED)
        fprintf(f, "no program");
    else if (n->lp.state == LP_ENDED)
        fprintf(f, "ended at %.9f s", vt_seconds(n->stats.ended_at));
    else if (!n->call)
        fprintf(f, "computing");
    else if (n->call_since == VT_NEVER)
        fprintf(f, "before %s", n->call);
    else if (n->call_has_type)
        fprintf(f, "%s(%ld) since %.9f s", n->call, n->call_type, vt_seconds(n->call_since));
    else
        fprintf(f, "%s since %.9f s", n->call, vt_seconds(n->call_since));
    const char *line = n->lp.state == LP_ENDED ? NULL : line_of(n, lines);
    if (line)
        fprintf(f, " (%s)", line);
}

char *whereabouts(const struct node_system *s, const char *what)
{
    char *text;
    size_t size;
    struct trace_lines *lines = trace_lines_new();
    FILE *f = xchecked(open_memstream(&text, &size));
    fprintf(f, "%s", what);
    if (s->host)
        describe_waiting(f, s->host, lines);
    for (uint32_t i = 0; i < s->count; i++)
        describe_waiting(f, s->nodes[i], lines);
    trace_lines_free(lines);
    fclose(f);
    return text;
}
