/* explore_command.c - touchstone explore: a program under other timings. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "lab/commands/lab_commands.h"
#include "lab/commands/standard_input.h"
#include "cli/host_files.h"
#include "cli/installation.h"
#include "cli/program_options.h"
#include "cli/say.h"
#include "kernel/xalloc.h"
#include "lab/explore/explore_json.h"
#include "lab/explore/explore_report.h"
#include "lab/jobs/session.h"
#include "timing/draw_read.h"

enum { RUNS = CLI_KEY, SECONDS, BOUNDS, DEPTH, TESTS, SAME_FILE };
enum { USUAL_RUNS = 200, USUAL_TESTS = 200, USUAL_EXPLAINED = 8, USUAL_WALL_S = 600 };

struct arguments {
    struct cli_program what;
    struct cli_host_files files;
    const char *dir, *same, *same_file, *json;
    unsigned jobs;
    uint32_t runs, tests, depth; /* 0: not said */
    double seconds;
    struct draw draw;
    bool ordered;
    char *input; /* standard input, of so many bytes */
    size_t input_bytes;
};

static const struct argp_option OPTIONS[] = {
    {NULL, 0, NULL, 0, "Runs:", 2},
    {"runs", RUNS, "N", 0, "At most N runs; default 200, with --seconds no limit", 0},
    {"seconds", SECONDS, "S", 0, "Begin no run after S seconds", 0},
    {"bounds", BOUNDS, "KEY=VALUE,...", 0,
     "The longest delays: messages=100us,interrupts=50us,start=1ms,speed=2% by default", 0},
    {"depth", DEPTH, "D", 0, "Runs in the manner of PCT have depths 1 to D; default 3", 0},
    {NULL, 0, NULL, 0, "What is compared:", 4},
    {"same", CLI_TEXT(arguments, same), "REGEX", 0,
     "Only lines of standard output that match REGEX (extended, POSIX); default all", 0},
    {"same-file", SAME_FILE, "FILE", 0,
     "The bytes of a file that the program writes, also in /cfs; standard output only with --same", 0},
    {"ordered", CLI_FLAG(arguments, ordered), NULL, 0,
     "Lines must come in the same order; by default lines of different nodes may mix", 0},
    {NULL, 0, NULL, 0, "Results:", 5},
    {"output", 'o', "DIR", 0,
     "Folder for journal, recordings and schedules; default out/ and PROGRAM.explore", 0},
    {"json", CLI_TEXT(arguments, json), "FILE", 0,
     "Write what was found as JSON, too; '-' is standard output, which has no text then", 0},
    {"tests", TESTS, "N", 0,
     "At most N runs to find the fewest delays that show an outcome; default 200; for 8 outcomes at most", 0},
    {0}};

static const char DOC[] =
    "Runs PROGRAM, built by nxcc, under other timings that the machine could have had, and reports what "
    "differs from the usual timing: deadlocks, crashes, output. Messages leave later, interrupts come later, "
    "programs start later and nodes compute slower, within bounds: at random; by priorities (PCT); and "
    "directed at receives that could have got another message, and handlers that could have run later.\v"
    "For each outcome that differs there is a command that repeats it exactly, the fewest delays that show "
    "it, in DIR/NAME.schedule, and where the run first differs: which receive got which message.\n\n"
    "Files in DIR: journal, the schedules NAME.schedule, and runs/, the recordings of runs.\n\n"
    "Each result is in DIR/journal before the next run begins: after Ctrl-C or kill -9 the same command goes "
    "on. mpirun --enable-recovery -np 64 touchstone explore ... (or srun -n 64 ...) shares the runs among "
    "processes that see the same folder DIR.\n\n"
    "A run that passes the limit of virtual time fails: by default 10 times the time of the usual timing, "
    "and 1 s. A run that passes the limit of real time, by default 600 s, counts for nothing.\n\n"
    "If PROGRAM is not here, touchstone looks among the programs that come with it, as touchstone run does. "
    "A run works in a folder of its own with links to the files of the current folder: name other files by "
    "absolute paths. Each run has a copy of standard input, which is read to its end first, unless it is a "
    "terminal.\n\n"
    "Exit status:\n"
    "  0    all runs had the same outcome\n"
    "  1    outcomes differ, or the run with the usual timing fails\n"
    "  64   wrong arguments\n"
    "  65   the program or the machine cannot be used\n"
    "  74   a result cannot be written\n"
    "  128  and more: stopped by the signal of that number less 128\n\n"
    "Example:\n"
    "  touchstone explore -m ipsc860 -n 8 --same '^sum' --runs 500 solver";

static void set_bounds(struct argp_state *state, struct arguments *a, const char *text)
{
    char *whole = xasprintf("1,%s", text), *wrong = draw_read(whole, &a->draw);
    if (wrong)
        argp_error(state, "--bounds: %s", wrong);
    free(wrong);
    free(whole);
}

static void set_same_file(struct argp_state *state, struct arguments *a, const char *path)
{
    while (!strncmp(path, "./", 2))
        path += 1 + strspn(path + 1, "/");
    bool above = !strncmp(path, "../", 3) || strstr(path, "/../");
    bool in_cfs = !strncmp(path, "/cfs/", 5) || !strncmp(path, "/pfs/", 5);
    if (!*path || above || (*path == '/' && !in_cfs))
        argp_error(state,
                   "--same-file takes a file in the current folder or in /cfs, not '%s': each run works in a "
                   "folder of its own",
                   path);
    a->same_file = path;
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (key == ARGP_KEY_INIT)
        state->child_inputs[0] = &a->what, state->child_inputs[1] = &a->jobs,
        state->child_inputs[2] = &a->files;
    else if (key == 'o')
        a->dir = arg;
    else if (key == RUNS)
        a->runs = cli_whole(state, "--runs", "a number of runs", UINT32_MAX, arg);
    else if (key == SECONDS)
        a->seconds = cli_seconds(state, "--seconds", arg);
    else if (key == SAME_FILE)
        set_same_file(state, a, arg);
    else if (key == BOUNDS)
        set_bounds(state, a, arg);
    else if (key == DEPTH)
        a->depth = cli_whole(state, "--depth", "a depth", DRAW_DEEPEST, arg);
    else if (key == TESTS)
        a->tests = cli_whole(state, "--tests", "a number of runs", UINT32_MAX, arg);
    else if (key == ARGP_KEY_END)
        a->draw.depth = a->depth ? a->depth : a->draw.depth;
    else
        return cli_store(key, arg, state);
    return 0;
}

static int failed(char *error, int status)
{
    return cli_failed("explore", error, status);
}

/* --- standard input ------------------------------------------------------------------------------------- */

static bool is_regular(int fd)
{
    struct stat st;
    return !fstat(fd, &st) && S_ISREG(st.st_mode);
}

/* All of it, once, for all runs. */
static bool read_input(struct arguments *a, const struct session *t, char **error)
{
    if (standard_input_read(&a->input, &a->input_bytes, error) && a->input_bytes && t->count > 1 &&
        !is_regular(STDIN_FILENO))
        *error =
            xasprintf("only one of the processes has this standard input: start them as in mpirun -np %u "
                      "sh -c 'touchstone explore ... <FILE'",
                      t->count);
    return !*error;
}

/* --- doing it ------------------------------------------------------------------------------------------- */

static int report(struct explore *x, const struct arguments *a)
{
    char *error = NULL;
    explore_print(x, a->json && !strcmp(a->json, "-") ? stderr : stdout);
    if (fflush(stdout) || ferror(stdout))
        return failed(xasprintf("standard output cannot be written: %m"), CLI_EXIT_OUTPUT);
    if (a->json && !explore_json(x, a->json, &error))
        return failed(error, CLI_EXIT_OUTPUT);
    return x->search.outcome_count > 1 || !explore_usual_ended(x);
}

static int explore(const struct explore_options *o, const struct arguments *a)
{
    char *error = NULL;
    struct explore *x = explore_open(o, &error);
    if (!x)
        return failed(error, CLI_EXIT_INPUT);
    int status;
    if (explore_run(x, &error))
        status =
            explore_reports(x) ? report(x, a) : 0; /* mpirun ends all when one ends with another status */
    else if (error)
        status = failed(error, CLI_EXIT_INPUT);
    else {
        fprintf(o->notes, "stopped: %zu runs are in %s/journal; the same command goes on from there\n",
                x->place.done, o->dir);
        status = 128 + x->place.signal;
    }
    explore_close(x);
    return status;
}

/* out/NAME.explore */
static char *usual_folder(const struct arguments *a)
{
    return xasprintf("out/%s.explore", basename(a->what.program_count ? a->what.program[0] : a->what.host));
}

/* How runs are compared, as a text: with other rules they are other results. */
static char *rules_text(const struct arguments *a)
{
    return xasprintf("%s%s%s", a->ordered ? "ordered " : "", a->same ? "same " : "", a->same ? a->same : "");
}

static void set_session(struct explore_options *o, const struct session *t, const struct arguments *a)
{
    o->session = t->name;
    o->at_once = !a->jobs && t->count > 1 ? 1 : cli_jobs(a->jobs);
    if (t->rank > 0) { /* the first process shows the progress of all */
        FILE *nowhere = fopen("/dev/null", "we");
        o->notes = nowhere ? nowhere : stderr;
    }
}

static int explore_with(struct arguments *a, const regex_t *same)
{
    struct cli_installation places;
    struct session t = session_find();
    char *error = NULL;
    if (!cli_find_installation(&places, "explore"))
        return CLI_EXIT_INPUT;
    if (!cli_program_find(&a->what, places.programs, false, &error) || !read_input(a, &t, &error))
        return failed(error, CLI_EXIT_INPUT);
    char *folder = usual_folder(a), *rules = rules_text(a);
    struct explore_options o = {.subject = {.runner = places.runner,
                                            .machines = places.machines,
                                            .machine = a->what.machine,
                                            .host = a->what.host,
                                            .set = a->what.set,
                                            .host_files = a->files.list,
                                            .program = a->what.program,
                                            .program_count = a->what.program_count,
                                            .programs = a->what.programs,
                                            .programs_count = a->what.programs_count,
                                            .nodes = a->what.nodes,
                                            .max_virtual_s = a->what.max_virtual_s,
                                            .max_unreceived_mb = a->what.max_unreceived_mb,
                                            .rules = rules,
                                            .compare_file = a->same_file,
                                            .input = a->input,
                                            .input_bytes = a->input_bytes},
                                .rules = {same, a->ordered, a->same_file && !a->same},
                                .dir = a->dir ? a->dir : folder,
                                .draw = a->draw,
                                .runs = a->runs          ? a->runs
                                        : a->seconds > 0 ? UINT32_MAX
                                                         : USUAL_RUNS,
                                .seconds = a->seconds,
                                .limit_s = a->what.max_wall_s > 0 ? a->what.max_wall_s : USUAL_WALL_S,
                                .tests = a->tests ? a->tests : USUAL_TESTS,
                                .explained = USUAL_EXPLAINED,
                                .notes = stderr};
    set_session(&o, &t, a);
    int status = explore(&o, a);
    if (o.notes != stderr)
        fclose(o.notes);
    free(folder);
    free(rules);
    return status;
}

static int explore_same(struct arguments *a)
{
    regex_t same;
    if (!a->same)
        return explore_with(a, NULL);
    int wrong = regcomp(&same, a->same, REG_EXTENDED | REG_NOSUB);
    if (wrong) {
        char why[128];
        regerror(wrong, &same, why, sizeof why);
        return failed(xasprintf("--same '%s': %s", a->same, why), 64);
    }
    int status = explore_with(a, &same);
    regfree(&same);
    return status;
}

static const struct argp_child CHILDREN[] = {
    {&CLI_PROGRAM, 0, NULL, 0}, {&CLI_JOBS, 0, NULL, 2}, {&CLI_RUNS_HOST_FILES, 0, NULL, 0}, {0}};
static const struct argp ARGP = {OPTIONS, parse, CLI_PROGRAM_ARGUMENTS, DOC, CHILDREN, NULL, NULL};

int cli_explore(int argc, char **argv)
{
    struct arguments a = {.draw = draw_usual()};
    cli_parse(&ARGP, "touchstone explore", ARGP_IN_ORDER, argc, argv, &a);
    int status = explore_same(&a);
    cli_program_free(&a.what);
    free(a.files.list);
    free(a.input);
    return status;
}
