/* timing_options.c - see timing_options.h. */
#include "cli/timing_options.h"
#include <stdlib.h>
#include "timing/draw_read.h"

enum { TIMING = CLI_KEY + 0x4000, REPLAY, RECORD, UNTIL };

static const struct argp_option OPTIONS[] = {
    {NULL, 0, NULL, 0, "Another timing that the machine could have had:", 4},
    {"timing", TIMING, "SEED[,KEY=VALUE...]", 0,
     "Delay messages, interrupts, starts and processors at random. Keys: method=random|pct (default random); "
     "bounds messages=100us, interrupts=50us, start=1ms, speed=2%; for pct depth=3 and length=1000, "
     "the number of messages and interrupts of the run",
     0},
    {"replay", REPLAY, "FILE", 0, "Run with the delays, or in the orders, of a schedule", 0},
    {"record", RECORD, "FILE", 0, "Write the run's schedule: what was delayed, who got which message, when",
     0},
    {"until", UNTIL, "TIME", 0,
     "Stop at a virtual time, such as 1.5s, 12ms, 3us, and report where each node is; with --gdb, as --at",
     3}, /* among the limits of a run (program_options.c) */
    {0}};

static void take_timing(struct argp_state *state, struct timing_arguments *a, const char *text)
{
    char *wrong = draw_read(text, &a->draw);
    a->drawn = true;
    if (wrong)
        argp_error(state, "--timing: %s", wrong);
    free(wrong);
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct timing_arguments *a = state->input;
    if (key == TIMING)
        take_timing(state, a, arg);
    else if (key == REPLAY)
        a->replay = arg;
    else if (key == RECORD)
        a->record = arg;
    else if (key == UNTIL)
        a->until = cli_later_time(state, "--until", arg);
    else if (key != ARGP_KEY_END)
        return ARGP_ERR_UNKNOWN;
    else if (a->drawn && a->replay)
        argp_error(state, "--timing draws delays, and --replay has its own: give one of them");
    return 0;
}

const struct argp CLI_TIMING = {OPTIONS, parse, NULL, NULL, NULL, NULL, NULL};
