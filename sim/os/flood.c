/* flood.c - see flood.h. */
#include "os/flood.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include "files/virtual_time.h"
#include "kernel/xalloc.h"
#include "nx_api/waitfor/waitfor_mpi.h"
#include "os/first_failure.h"

enum { TIMES_MEMORY = 4 };
#define MOST ((size_t)4 << 30)

size_t flood_limit(size_t said, size_t memory)
{
    size_t limit = TIMES_MEMORY * memory;
    return said ? said : limit < MOST ? limit : MOST;
}

/* Of m's type, how many wait at n; and of them, how many are from m's sender. */
static void print_like(FILE *f, const struct node *n, const struct message *m)
{
    uint64_t alike = 0, from = 0;
    for (const struct message *w = n->mailbox.whole; w; w = w->next)
        if (w->type == m->type && w->pid == m->pid)
            alike++, from += w->source == m->source;
    bool mpi = waitfor_is_mpi(m->pid);
    fprintf(f, "%" PRIu64 " of them are of %s %" PRId32, alike, mpi ? waitfor_mpi_type(m->pid) : "type",
            m->type);
    if (mpi) {
        fprintf(f, " on ");
        waitfor_print_communicator(f, m->pid);
    }
    fprintf(f, ", %" PRIu64 " of these from %s", from, node_at(n->sys, m->source)->cold->name);
}

/* What a program that waits or has ended does is known. Of one that computes, it differs from run to run how
 * far it has come. */
static void print_receiver(FILE *f, const struct node *n)
{
    if (n->lp.state == LP_ENDED) {
        fprintf(f, "\n  the program of %s ended at %s", n->cold->name,
                virtual_time_moment(n->stats.ended_at).text);
    } else if (n->lp.state == LP_BLOCKED && n->call.name) {
        fprintf(f, "\n  %s waits in %s", n->cold->name, n->call.name);
        if (n->call.has_type)
            fprintf(f, "(%ld)", n->call.type);
        fprintf(f, " since %s", virtual_time_moment(n->call.since).text);
        if (n->sys->print_calls)
            n->sys->print_calls(f, n, n->wait.frame);
    }
}

static __attribute__((noinline, cold)) void flooded(const struct node *n, const struct message *m)
{
    char *text;
    size_t size;
    const struct instant now = n->sys->schedule.reached;
    FILE *f = xchecked(open_memstream(&text, &size));
    fprintf(f,
            "%s is flooded: at %s, %" PRIu32
            " messages of %zu bytes in all wait there, which no receive has taken; ",
            n->cold->name, virtual_time_moment(now.time).text, n->unexpected.count, n->memory.buffered);
    print_like(f, n, m);
    print_receiver(f, n);
    fprintf(f,
            "\n  Let the sender wait for an answer now and then, or receive the messages; "
            "--max-unreceived gives them more room than %zu MB.",
            n->sys->most_unreceived >> 20);
    fclose(f);
    node_system_fail(n->sys, STOP_FAILED, now, "%s", text);
    free(text);
}

void flood_check(struct node *n, const struct message *m)
{
    if (n->memory.buffered + (size_t)n->unexpected.count * FLOOD_EACH > n->sys->most_unreceived)
        flooded(n, m);
}
