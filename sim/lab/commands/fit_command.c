/* fit_command.c - touchstone fit: numbers of the machine or of the program, so that a study comes near
 * measurements. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "lab/commands/lab_commands.h"
#include "cli/say.h"
#include "lab/commands/study_session.h"
#include "lab/fit/fit.h"

enum { EXIT_UNDETERMINED = 1, MOST_EVALUATIONS = 1000000 };

enum { MOST = CLI_KEY };

struct arguments {
    struct cli_study_arguments study;
    const char *constants, *json;
    unsigned most;
};

static const struct argp_option OPTIONS[] = {
    {"constants", CLI_TEXT(arguments, constants), "FILE", 0,
     "Write the fitted numbers, with their provenance, to FILE; default DIR/fitted.cfg", 1},
    {"json", CLI_TEXT(arguments, json), "FILE", 0,
     "Write the result as JSON, too; '-' is standard output, which has no text then", 1},
    {"most", MOST, "N", 0, "Evaluate all points at most N times in the search; default 200", 1},
    {"output", 'o', "DIR", 0, "Folder for the results of runs; default out/ and STUDY's name and -fit", 1},
    {0}};

static const char DOC[] =
    "Searches for the numbers of a machine, or of a program's arguments, with which the points of a study "
    "come nearest to measurements, in the sense of least squares. Reports how sensitive each figure is to "
    "each number, and which numbers the measurements do not determine. After an interruption the same "
    "command continues.\v"
    "The study file is one of touchstone study, with one group more:\n"
    "  fit = {\n"
    "    parameters = (\n"
    "      { name = \"send\"; set = \"system.short_send_us={}\";\n"
    "        from = 10.0; to = 200.0; start = 50.0; }, # default start: the middle\n"
    "      { name = \"k\"; arguments = \"-k {}\"; from = 1.0; to = 4.0;\n"
    "        logarithmic = true; }\n"
    "    );\n"
    "    # a line of names (axes, figures, weight), then lines of values\n"
    "    measurements = \"measured.csv\";\n"
    "    weights = \"relative\"; # or \"rounding\": residuals are in halves of a unit\n"
    "                          # of the measurement's last digit\n"
    "  };\n\n"
    "A parameter may also be a cost factor of the compiler, factor = \"slice.c\" in place of set. The "
    "program is then built for each value:\n"
    "  build = \"nxcc -O2 --factors {factors} -o {program} a.c\";\n\n"
    "Files in DIR: fitted.cfg, the numbers, unless --constants names another; and the runs, as touchstone "
    "study keeps them.\n\n"
    "Exit status:\n"
    "  0   all numbers are determined\n"
    "  1   some are not; they are named\n"
    "  64  wrong arguments\n"
    "  65  study file or measurements cannot be used, or the results not written\n"
    "  128  and more: stopped by the signal of that number less 128\n\n"
    "Example:\n"
    "  touchstone fit send.cfg --constants mine.cfg";

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (key == ARGP_KEY_INIT)
        state->child_inputs[0] = &a->study.session;
    else if (key == MOST)
        a->most = cli_whole(state, "--most", "a number of evaluations", MOST_EVALUATIONS, arg);
    else
        return cli_study_argument(key, arg, state, &a->study);
    return 0;
}

static int fit(const struct arguments *a, struct fit_options *o)
{
    char dir[PATH_MAX], constants[PATH_MAX + 16], *error = NULL;
    cli_default_folder(a->study.file, "-fit", dir);
    o->study.file = a->study.file;
    o->study.dir = a->study.dir ? a->study.dir : dir;
    if (!isatty(STDERR_FILENO)) /* where the lines of the studies' progress would hide those of the fit */
        cli_session_silence(&o->study);
    snprintf(constants, sizeof constants, "%s/fitted.cfg", o->study.dir);
    o->constants = a->constants ? a->constants : constants;
    enum fit_end end = fit_run(o, &error);
    if (end == FIT_ERROR)
        cli_say_error("fit", "%s", error);
    free(error);
    return end == FIT_DONE           ? 0
           : end == FIT_UNDETERMINED ? EXIT_UNDETERMINED
           : *o->signal              ? 128 + *o->signal
                                     : CLI_EXIT_INPUT;
}

int cli_fit(int argc, char **argv)
{
    static const struct argp_child CHILDREN[] = {{&CLI_SESSION, 0, NULL, 0}, {0}};
    static const struct argp ARGP = {OPTIONS, parse, "STUDY", DOC, CHILDREN, NULL, NULL};
    struct arguments a = {.most = 200};
    int signal = 0;
    struct cli_session s;
    cli_parse(&ARGP, "touchstone fit", 0, argc, argv, &a);
    struct fit_options o = {.most = a.most,
                            .json = a.json,
                            .out = a.json && !strcmp(a.json, "-") ? stderr : stdout,
                            .progress = stderr,
                            .signal = &signal};
    if (!cli_session_begin(&s, "fit", &a.study.session, &o.study))
        return CLI_EXIT_INPUT;
    int status = fit(&a, &o);
    cli_session_end(&s, &o.study);
    return status;
}
