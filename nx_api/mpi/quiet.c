/* quiet.c - see quiet.h. */
#include "nx_api/mpi/quiet.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include "nx_api/mpi/mpi_node.h"
#include "nx_api/mpi/mpi_wire.h"
#include "nx_api/mpi/safra.h"

struct note {
    struct safra_token token;
    double patience; /* seconds */
};

static struct safra ring;
static double patience, next_wave; /* next_wave: when node 0 may begin another, in seconds of mpi_seconds() */

static const double PATIENCE_S = 1, BETWEEN_WAVES_S = 0.02;

/* Seconds; infinite: never. */
static double patience_of(struct node *n, const char *text)
{
    char *end;
    if (!text || !*text)
        return PATIENCE_S;
    if (strcmp(text, "off") == 0)
        return INFINITY;
    double seconds = strtod(text, &end);
    if (*end || !(seconds >= 0))
        node_fail(n, "NX_DEADLOCK is '%s', but should be a number of seconds, or off", text);
    return seconds;
}

void quiet_begin(struct node *n)
{
    safra_begin(&ring, (uint32_t)n->id, n->sys->count);
    patience = INFINITY; /* but on node 0 the token will say */
    if (n->id == 0)
        patience = patience_of(n, getenv("NX_DEADLOCK"));
}

void quiet_sent(uint32_t count)
{
    while (count--)
        safra_sent(&ring);
}

void quiet_received(void)
{
    safra_received(&ring);
}

void quiet_take(const void *bytes)
{
    struct note note;
    memcpy(&note, bytes, sizeof note);
    safra_take(&ring, note.token);
    patience = note.patience;
}

static void pass(struct node *n)
{
    const struct note note = {safra_pass(&ring), patience};
    if (n->sys->count == 1)
        quiet_take(&note);
    else
        wire_send(n, (n->id + 1) % n->sys->count, (struct wire_head){.kind = WIRE_TOKEN}, &note, sizeof note);
}

static bool has_timer(void)
{
    struct itimerval t;
    for (int which = ITIMER_REAL; which <= ITIMER_PROF; which++)
        if (getitimer((__itimer_which_t)which, &t) == 0 && (t.it_value.tv_sec || t.it_value.tv_usec))
            return true;
    return false;
}

bool quiet_look(struct node *n, double since)
{
    if (!ring.has_token || isinf(patience))
        return false;
    double now = mpi_seconds();
    if (now - since < patience || (!n->over && has_timer()))
        return false;
    if (n->id == 0) {
        if (safra_judge(&ring))
            return true;
        if (now < next_wave)
            return false;
        next_wave = now + BETWEEN_WAVES_S;
    }
    pass(n);
    return false;
}

bool quiet_settle(struct node *n)
{
    if (n->id == 0)
        return ring.has_token;
    if (ring.has_token)
        pass(n);
    return true;
}
