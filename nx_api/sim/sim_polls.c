/* sim_polls.c - polls that find nothing, for reports of livelocks (os/livelock.h). */
#include "guest/backtrace.h"
#include "nx_api/calls/call.h"
#include "os/charge.h"
#include "os/livelock.h"

/* The frames of the call itself come first: they lie outside of the program. */
enum { CALL_FRAMES = 4 };

static void find_places(const struct node *n, uintptr_t frame, uintptr_t *places)
{
    uintptr_t returns[CALL_FRAMES + LIVELOCK_PLACES];
    int depth = backtrace_walk(n, frame, returns, CALL_FRAMES + LIVELOCK_PLACES), count = 0;
    for (int i = 0; i < depth && count < LIVELOCK_PLACES; i++)
        if (backtrace_in_program(n, returns[i]))
            places[count++] = returns[i];
}

/* Where the program has called: quick, since all frames up to there are those of this call. 0: not found. */
static uintptr_t place_of(const struct node *n, const uintptr_t *frame)
{
    for (int i = 0; i < CALL_FRAMES; i++, frame = (const uintptr_t *)frame[0])
        if (backtrace_in_program(n, frame[1]))
            return frame[1];
    return 0;
}

void nx_found_nothing(struct node *n, const struct selector *select)
{
    const struct cfg_machine *cfg = n->sys->cfg;
    const uintptr_t *frame = __builtin_frame_address(0);
    vtime spent = node_system_time(n, cfg->call_ps) + (select ? 0 : node_system_time(n, cfg->kernel_ps));
    uintptr_t *places = livelock_found_nothing(n, select, place_of(n, frame), spent);
    if (places)
        find_places(n, (uintptr_t)frame, places);
}
