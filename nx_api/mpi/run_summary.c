/* run_summary.c - see run_summary.h. */
#include "nx_api/mpi/run_summary.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "nx_api/mpi/mpi_node.h"
#include "nx_api/mpi/mpi_wire.h"
#include "nx_api/mpi/summary_text.h"

bool summary_wanted;

static struct summary_part own;
static double wait_began, handled_before, handler_began;
static bool in_handler;
static struct summary_part *parts; /* on node 0, by node */

void summary_begin(struct node *n)
{
    const char *text = getenv("NX_SUMMARY"), *file = getenv("NX_SUMMARY_JSON");
    char wanted = (text && *text && strcmp(text, "0") != 0) || (file && *file);
    wire_share(&wanted, sizeof wanted);
    summary_wanted = wanted;
    if (wanted && n->id == 0 && !(parts = calloc(n->sys->count, sizeof *parts)))
        node_fail(n, "NX_SUMMARY: out of memory");
}

void summary_send(const struct node *n, long node, size_t bytes)
{
    uint64_t messages = node < 0 ? n->sys->count - 1 : 1;
    own.sent += messages;
    own.bytes += messages * bytes;
}

/* --- waits and handlers --- */

/* A handler that waits is a handler all the while. */
void summary_wait(void)
{
    if (in_handler)
        return;
    wait_began = mpi_seconds();
    handled_before = own.handlers_s;
}

static struct summary_wait *wait_of(const char *call)
{
    size_t i = 0;
    while (i < own.wait_count && strcmp(own.waits[i].call, call) != 0)
        i++;
    if (i == SUMMARY_MOST_CALLS)
        return NULL;
    if (i == own.wait_count)
        strncpy(own.waits[own.wait_count++].call, call, sizeof own.waits[i].call - 1);
    return &own.waits[i];
}

void summary_go_on(const struct node *n)
{
    struct summary_wait *w = in_handler || !n->call.name ? NULL : wait_of(n->call.name);
    if (!w)
        return;
    w->times++;
    w->seconds += mpi_seconds() - wait_began - (own.handlers_s - handled_before);
}

void summary_handler(void)
{
    in_handler = true;
    handler_began = mpi_seconds();
}

void summary_handled(void)
{
    in_handler = false;
    own.handlers++;
    own.handlers_s += mpi_seconds() - handler_began;
}

/* --- the end --- */

void summary_fail(void)
{
    own.failed = true;
}

void summary_end(struct node *n, int status)
{
    own.ended_s = mpi_seconds();
    own.exit_code = status;
    gethostname(own.host, sizeof own.host - 1);
    wire_send(n, 0, (struct wire_head){.kind = WIRE_SUMMARY}, &own, sizeof own);
}

void summary_part(uint32_t node, const void *bytes, size_t count)
{
    if (count == sizeof *parts)
        memcpy(&parts[node], bytes, count);
}

void summary_write(struct node *n, bool deadlock)
{
    const char *text = getenv("NX_SUMMARY"), *file = getenv("NX_SUMMARY_JSON");
    if (text && *text && strcmp(text, "0") != 0)
        summary_write_text(parts, n->sys->count);
    if (file && *file)
        summary_write_json(parts, n->sys->count, deadlock, file);
}
