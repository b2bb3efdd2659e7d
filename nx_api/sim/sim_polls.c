/* sim_polls.c - polls that find nothing, for reports of livelocks (os/livelock.h). */
#include "guest/backtrace.h"
#include "kernel/crossing.h"
#include "nx_api/calls/call.h"
#include "os/charge.h"
#include "os/livelock.h"

static void find_places(const struct node *n, uintptr_t frame, uintptr_t *places)
{
    uintptr_t returns[LIVELOCK_PLACES];
    int depth = backtrace_walk(n, frame, returns, LIVELOCK_PLACES), count = 0;
    for (int i = 0; i < depth; i++)
        if (backtrace_in_program(n, returns[i]))
            places[count++] = returns[i];
}

void nx_found_nothing(struct node *n, const struct selector *select)
{
    const struct cfg_machine *cfg = n->sys->cfg;
    vtime spent = node_system_time(n, cfg->call_ps) + (select ? 0 : node_system_time(n, cfg->kernel_ps));
    uintptr_t *places = livelock_found_nothing(n, select, crossing_caller(), spent);
    if (places)
        find_places(n, (uintptr_t)crossing_frame(), places);
}
