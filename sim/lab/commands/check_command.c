/* check_command.c - touchstone check: studies against a baseline. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "lab/commands/lab_commands.h"
#include "cli/say.h"
#include "lab/commands/study_session.h"
#include "lab/check/compare_gate.h"

enum { EXIT_WORSE = 1, EXIT_UNKNOWN = 2 };

enum { TOLERANCE = CLI_KEY };

struct arguments {
    struct gate_options gate;
    struct cli_session_options session;
};

static const struct argp_option OPTIONS[] = {
    {"update", CLI_FLAG(arguments, gate.update), NULL, 0,
     "Make the results the baseline, and show what changed; makes a missing file", 1},
    {"tolerance", TOLERANCE, "T", 0,
     "How much worse figures may be: 0.5%, or total_s=1%,messages=10; may be repeated; default 0", 1},
    {"exact", CLI_FLAG(arguments, gate.rules.exact), NULL, 0,
     "Any difference of any figure fails, also for the better, also of the digest", 1},
    {"junit", CLI_TEXT(arguments, gate.junit), "FILE", 0,
     "Write the results as JUnit XML, too, a test case a point", 1},
    {"json", CLI_TEXT(arguments, gate.json), "FILE", 0,
     "Write verdict and figures of each point as JSON, too; '-' is standard output, which has no text then",
     1},
    {"github", CLI_FLAG(arguments, gate.github), NULL, 0,
     "Write a line for each point that is worse, which GitHub Actions shows as an annotation", 1},
    {"only", CLI_TEXT(arguments, gate.rules.only), "FIGURE", 0,
     "Compare this figure only, and show a line a point, the worst first", 1},
    {"output", 'o', "DIR", 0, "Folder for the results of the runs, in DIR/STUDY; default out", 1},
    {0}};

static const char DOC[] =
    "Runs studies (see touchstone study --help) and compares each point with a baseline. Reports which "
    "points are worse, the worst first, by how much, and where the time of their nodes moved: by function, "
    "if the program was built with nxcc --profile and the study file says profile = true.\v"
    "A point is worse if total_s, time_s, virtual_time_s, messages, bytes or memory_peak_bytes grows, or "
    "speedup or speed_per_node shrinks. Other figures are shown, but fail only if --tolerance names them, "
    "and then by any difference beyond it. Results are exact, so that a repeated run "
    "needs no tolerance.\n\n"
    "Files: BASELINE.json, with --update; of each study, DIR/STUDY with the files of touchstone study.\n\n"
    "Exit status:\n"
    "  0  no point is worse\n"
    "  1  a point is worse, missing or failed\n"
    "  2  the comparison was not possible; wrong arguments\n\n"
    "Example:\n"
    "  touchstone check baseline.json --update study.cfg   # once\n"
    "  touchstone check baseline.json study.cfg            # after each change";

static void add_tolerance(struct argp_state *state, struct compare_rules *rules, const char *text)
{
    char *why = NULL;
    if (!compare_rules_add(rules, text, &why))
        argp_error(state, "--tolerance: %s", why);
    free(why);
}

static void take_files(struct argp_state *state, struct gate_options *gate)
{
    if (state->argc - state->next < 2)
        argp_error(state, "which study file?");
    gate->baseline = state->argv[state->next];
    gate->files = (const char *const *)state->argv + state->next + 1;
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (key == ARGP_KEY_INIT)
        state->child_inputs[0] = &a->session;
    else if (key == TOLERANCE)
        add_tolerance(state, &a->gate.rules, arg);
    else if (key == 'o')
        a->gate.dir = arg;
    else if (key == ARGP_KEY_ARGS)
        take_files(state, &a->gate);
    else if (key == ARGP_KEY_NO_ARGS)
        argp_error(state, "which baseline, and which study file?");
    else if (key == ARGP_KEY_END && a->gate.rules.exact && a->gate.rules.count)
        argp_error(state, "--exact leaves no room for --tolerance");
    else
        return cli_store(key, arg, state);
    return 0;
}

static int check(struct arguments *a)
{
    struct cli_session s;
    char *error = NULL;
    if (!cli_session_begin(&s, "check", &a->session, &a->gate.study))
        return EXIT_UNKNOWN;
    a->gate.study.retry_failed = true;
    if (a->gate.json && !strcmp(a->gate.json, "-"))
        a->gate.study.out = stderr;
    enum gate_end end = gate_run(&a->gate, &error);
    if (end == GATE_ERROR)
        cli_say_error("check", "%s", error);
    free(error);
    cli_session_end(&s, &a->gate.study);
    return end == GATE_PASSED ? 0 : end == GATE_WORSE ? EXIT_WORSE : EXIT_UNKNOWN;
}

int cli_check(int argc, char **argv)
{
    static const struct argp_child CHILDREN[] = {{&CLI_SESSION, 0, NULL, 0}, {0}};
    static const struct argp ARGP = {OPTIONS, parse, "BASELINE.json STUDY...", DOC, CHILDREN, NULL, NULL};
    struct arguments a = {.gate.dir = "out"};
    argp_err_exit_status = EXIT_UNKNOWN; /* not 64: 2 stands for every error */
    cli_parse(&ARGP, "touchstone check", 0, argc, argv, &a);
    int status = check(&a);
    compare_rules_clear(&a.gate.rules);
    return status;
}
