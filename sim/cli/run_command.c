/* run_command.c - touchstone run: one program on one machine. */
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "cli/commands.h"
#include "cli/gdb_start.h"
#include "cli/host_files.h"
#include "cli/installation.h"
#include "cli/other_binary.h"
#include "cli/program_options.h"
#include "cli/result_paths.h"
#include "cli/run_files.h"
#include "cli/say.h"
#include "guest/elffile.h"
#include "guest/image.h"
#include "cli/stop_options.h"
#include "cli/timing_options.h"
#include "cli/trace_options.h"
#include "cli/version.h"
#include "guest/archive_sources.h"
#include "guest/debugger.h"
#include "kernel/xalloc.h"
#include "machine/call_filter.h"
#include "machine/machine.h"
#include "observe/race_json.h"
#include "observe/run_trace.h"
#include "observe/sarif.h"
#include "observe/summary.h"
#include "observe/time_profile.h"
#include "mpi_api/checks/mpi_checks.h"
#include "observe/race_print.h"
#include "observe/race_suppress.h"
#include "timing/plan_read.h"

enum { EXIT_FINDINGS = 3 };

enum { SLICE = CLI_KEY, SHUFFLE, TRACE_FROM, TRACE_TO, TRACE_NODES, GDB, AT, LAYER };

struct arguments {
    struct cli_program what;
    const char *json, *deadlock, *races, *sarif, *suppress, *profile, *history, *cfs, *engine;
    uint32_t workers, shuffle;
    double slice_s;
    bool quiet, verbose, isolate, mpi_checks, sensitivity;
    struct run_trace_options trace; /* path NULL: no trace */
    bool *traced_nodes;
    struct debug_stop_options stop;
    struct timing_arguments timing;
    struct cli_host_files host_files;
    char **layer; /* ended by NULL; NULL: none */
    size_t layer_count;
    struct plan *plan;            /* of timing.replay */
    struct named_program on_host; /* the host program, whose list of arguments is malloc'd; NULL: no host */
    char **environment;           /* as programs get it */
};

static const struct argp_option OPTIONS[] = {
    {"cfs", CLI_TEXT(arguments, cfs), "DIR", 0, "Folder with the files of /cfs; default a temporary one", 1},
    {NULL, 0, NULL, 0, "Results:", 2},
    {"json", CLI_TEXT(arguments, json), "FILE", 0, "Write the figures of run and nodes as JSON", 0},
    {"deadlock", CLI_TEXT(arguments, deadlock), "FILE", 0,
     "Write why the programs wait, in a deadlock, as JSON; 'null' if there is none", 0},
    {"races", CLI_TEXT(arguments, races), "FILE", 0,
     "Write the races found as JSON; for programs built with nxcc --races", 0},
    {"sarif", CLI_TEXT(arguments, sarif), "FILE", 0,
     "Write races, a deadlock, an error of --asan or a crash as SARIF, which editors and code hosts show", 0},
    {"suppress", CLI_TEXT(arguments, suppress), "FILE", 0,
     "Report no races that FILE names: lines 'file NAME:LINE', 'variable NAME', 'function NAME'", 0},
    {"mpi-checks", CLI_FLAG(arguments, mpi_checks), NULL, 0,
     "Report what MPI programs have not freed or completed at MPI_Finalize, and calls of ranks that do not "
     "fit together",
     0},
    {"layer", LAYER, "PATTERN", 0,
     "Treat functions as a message layer: reports name the line that called the layer, not a line inside of "
     "it. PATTERN names functions, such as 'MPI*'; source files if it has a '.', such as 'mpi*.c', or by "
     "whole path if it has a '/', such as '*/mpich/*'; or a library, lib/libmpi.a. May be repeated",
     0},
    {"profile", CLI_TEXT(arguments, profile), "FILE", 0,
     "Write as JSON, and show, where the time went, by function; for programs built with nxcc --profile", 0},
    {"sensitivity", CLI_FLAG(arguments, sensitivity), NULL, 0,
     "Run again with each number of the machine file changed by 1 %, and show on which ones the time depends",
     0},
    {"history", CLI_TEXT(arguments, history), "FILE", 0,
     "Write a line for each message received: picoseconds, sender, receiver, type, length", 0},
    {"trace", CLI_TEXT(arguments, trace.path), "FILE", 0,
     "Write what each node and message did, and when; see touchstone trace", 0},
    {"trace-from", TRACE_FROM, "TIME", 0, "Trace from a virtual time on, such as 1.5s, 12ms, 3us", 0},
    {"trace-to", TRACE_TO, "TIME", 0, "Trace up to a virtual time", 0},
    {"trace-nodes", TRACE_NODES, "LIST", 0, "Trace only nodes such as 0-7,12, and their messages", 0},
    {"quiet", 'q', NULL, 0, "No summary", 0},
    {"verbose", 'v', NULL, 0,
     "Add to the summary what the simulator's threads did, and where the program was found", 0},
    {NULL, 0, NULL, 0, "Debugger (gdb --args touchstone run ... works, too):", 5},
    {"gdb", GDB, "NODE", 0, "Start gdb, and stop at the beginning of main on NODE, a number or 'host'", 0},
    {"at", AT, "TIME", 0, "With --gdb: stop at the virtual time TIME instead, such as 1.5s, 12ms, 3us", 0},
    {NULL, 0, NULL, 0, "Simulator (no result depends on these):", 6},
    {"workers", 'w', "N", 0,
     "Compute with N threads; default $TOUCHSTONE_WORKERS, else the number of processors, at most 8", 0},
    {"engine", CLI_TEXT(arguments, engine), "fast|reference", 0,
     "The engine; 'reference', slow, defines what is right; default $TOUCHSTONE_ENGINE, or fast", 0},
    {"isolate", CLI_FLAG(arguments, isolate), NULL, 0,
     "Stop a program that writes into another node's memory, and say where; slow: see nxcc --asan", 0},
    {"slice", SLICE, "S", 0, "Return from computing programs at least every S virtual seconds; for tests", 0},
    {"shuffle", SHUFFLE, "SEED", 0, "Let the threads take tasks in a random order; for tests", 0},
    {0}};

static const char DOC[] =
    "Runs PROGRAM, built by nxcc, on every node of a simulated machine, by default delta. The nodes' "
    "output comes on standard output, in the order of virtual time; a summary follows on standard "
    "error. Where a result's FILE is '-', it has standard output for itself, and the nodes' output comes on "
    "standard error. If PROGRAM is not here, touchstone looks among the programs that come with it, such as "
    "app/model.\n\n"
    "With --host, HOST runs on the machine's host, by default ipsc860's. HOST loads the nodes itself: "
    "load(\"x\") finds PROGRAM by its name, or a program x beside HOST. ARGS are HOST's. With -n, HOST has "
    "its nodes from the start; without, it calls getcube.\v"
    "On SIGINT, SIGTERM or SIGHUP a run reports where each node is, and ends by that signal. If a second "
    "signal comes a second or more later, the run ends at once, without a report. On SIGUSR1 (kill -USR1 "
    "PROCESS) a run reports where each node is, and goes on.\n\n"
    "Exit status:\n"
    "  0   all programs ended\n"
    "  1   a program crashed, ended with an error or ran out of memory, or a limit\n"
    "      was reached\n"
    "  2   deadlock: every program waits, and no message is under way\n"
    "  3   all programs ended, but races were found (in programs built with\n"
    "      nxcc --races), or --mpi-checks has found something\n"
    "  64  wrong arguments\n"
    "  65  the machine or the program cannot be used\n"
    "  74  standard output or a result cannot be written\n\n"
    "Example:\n"
    "  nxcc -O2 -o ring ring.c && touchstone run -m ipsc860 -n 16 ring";

static struct result_paths results_of(const struct arguments *a)
{
    return (struct result_paths){
        {a->json, a->deadlock, a->races, a->profile, a->history, a->trace.path, a->timing.record, a->sarif}};
}

/* Has the run one of the nodes of --trace-nodes? */
static bool traces_some(const struct arguments *a)
{
    for (uint32_t i = 0; i < a->trace.node_count && i < cli_program_nodes(&a->what); i++)
        if (a->traced_nodes[i])
            return true;
    return false;
}

static void check(struct argp_state *state, struct arguments *a)
{
    const struct result_paths results = results_of(a);
    const char *twice = result_paths_twice(&results);
    if (result_paths_dashes(&results) > 1)
        argp_error(state, "standard output ('-') has room for one file");
    else if (twice)
        argp_error(state, "%s has room for one result, and two are to be written there", twice);
    if (a->engine && !cli_is_engine(a->engine))
        argp_error(state, "--engine takes 'fast' or 'reference', not '%s'", a->engine);
    if ((a->what.host || a->what.programs_count > 1) && a->profile)
        argp_error(state, "--profile is for one program that is on all nodes from the start%s",
                   a->what.host ? ", not with --host" : "");
    if (!a->trace.path && (a->trace.from || a->trace.to || a->traced_nodes))
        argp_error(state, "--trace-from, --trace-to and --trace-nodes need --trace FILE");
    if (a->traced_nodes && a->what.nodes && !traces_some(a))
        argp_error(state, "--trace-nodes: nodes are 0 to %u", cli_program_nodes(&a->what) - 1);
    if (a->sensitivity && (a->stop.wanted || a->timing.drawn || a->timing.replay || a->timing.until))
        argp_error(state,
                   "--sensitivity is of the usual timing to the end: not with --gdb, --timing, --replay "
                   "or --until");
    if (a->trace.to && a->trace.to <= a->trace.from)
        argp_error(state, "--trace-to must be later than --trace-from");
    if (a->stop.wanted && a->timing.until && !a->stop.time)
        a->stop.time = a->timing.until, a->timing.until = 0;
    cli_check_stop(state, &a->stop, a->what.host, cli_program_nodes(&a->what));
}

/* Takes the pattern, which is malloc'd. */
static void add_layer(struct arguments *a, char *pattern)
{
    a->layer = xreallocarray(a->layer, a->layer_count + 2, sizeof *a->layer);
    a->layer[a->layer_count++] = pattern;
    a->layer[a->layer_count] = NULL;
}

/* The sources stand for a library, so that a trace tells its layer without the library's file. */
static void take_layer(struct argp_state *state, struct arguments *a, const char *arg)
{
    const char *dot = strrchr(arg, '.');
    char *error = NULL;
    if (!dot || strcmp(dot, ".a") != 0) {
        add_layer(a, xstrdup(arg));
        return;
    }
    char **sources = archive_sources(arg, &error);
    if (!sources)
        argp_error(state, "--layer %s", error);
    for (size_t i = 0; sources && sources[i]; i++)
        add_layer(a, sources[i]);
    free(sources);
    free(error);
}

static void free_layer(const struct arguments *a)
{
    for (size_t i = 0; i < a->layer_count; i++)
        free(a->layer[i]);
    free(a->layer);
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (key == ARGP_KEY_INIT)
        state->child_inputs[0] = &a->what, state->child_inputs[1] = &a->timing,
        state->child_inputs[2] = &a->host_files;
    else if (key == 'w')
        a->workers = cli_whole(state, "-w", "a number of threads", CLI_MOST_WORKERS, arg);
    else if (key == SHUFFLE)
        a->shuffle = cli_whole(state, "--shuffle", "a seed", UINT32_MAX, arg);
    else if (key == SLICE)
        a->slice_s = cli_seconds(state, "--slice", arg);
    else if (key == TRACE_FROM)
        a->trace.from = cli_virtual_time(state, "--trace-from", arg);
    else if (key == TRACE_TO)
        a->trace.to = cli_later_time(state, "--trace-to", arg);
    else if (key == TRACE_NODES)
        cli_node_list(state, "--trace-nodes", arg, &a->traced_nodes, &a->trace.node_count, NULL);
    else if (key == GDB)
        cli_take_stop(state, &a->stop, arg);
    else if (key == AT)
        a->stop.time = cli_virtual_time(state, "--at", arg);
    else if (key == LAYER)
        take_layer(state, a, arg);
    else if (key == 'q')
        a->quiet = true;
    else if (key == 'v')
        a->verbose = true;
    else if (key == ARGP_KEY_END)
        a->trace.nodes = a->traced_nodes, check(state, a);
    else
        return cli_store(key, arg, state);
    return 0;
}

static int input_error(char *error)
{
    return cli_failed("run", error, CLI_EXIT_INPUT);
}

static int output_error(char *error)
{
    input_error(error);
    return CLI_EXIT_OUTPUT;
}

static char *cannot_write(const char *path)
{
    return xasprintf("%s cannot be written: %s", path, strerror(errno));
}

/* Has all output to f arrived? If not, errno says why. */
static bool flushed(FILE *f)
{
    errno = 0;
    bool good = fflush(f) == 0 && !ferror(f);
    errno = good || errno ? errno : ENOSPC; /* an earlier write failed, and its errno is gone */
    return good;
}

/* Shows the profile and writes it. Returns NULL, or an error. */
static char *report_profile(const struct machine *m, const struct arguments *a)
{
    struct profile p = profile_collect(m);
    if (!a->quiet)
        profile_print(&p, stderr);
    char *error = profile_json(&p, m, a->profile);
    profile_free(&p);
    return error;
}

/* NULL, or an error. */
static char *write_deadlock(const struct waitfor *w, const char *path)
{
    struct atomic_file f;
    char *error = NULL;
    if (!atomic_file_begin(&f, path, &error))
        return error;
    if (w)
        waitfor_write_json(w, f.out);
    else
        fputs("null", f.out);
    fputc('\n', f.out);
    atomic_file_end(&f, &error);
    return error;
}

static int status_of(const struct machine *m, const struct race_reports *races)
{
    if (m->outcome == MACHINE_ENDED || m->outcome == MACHINE_STOPPED)
        return races->count || races->dropped ? EXIT_FINDINGS : 0;
    return m->outcome == MACHINE_DEADLOCK ? 2 : 1;
}

static bool print_mpi_checks(const struct machine *m)
{
    return mpi_checks_print(m->sys.mpi_checks, "touchstone run: ", stderr);
}

/* Reports the error of writing a result, if there is one. One that cannot be written keeps no other back. */
static bool written(char *error)
{
    return !error || (output_error(error), false);
}

/* What follows may be a part of the report: it begins a line. */
static void end_line(const struct machine *m, const struct race_reports *races, bool quiet)
{
    if (m->sys.mid_line && ((m->message && !m->said) || !quiet || races->count || m->sys.mpi_checks))
        fputc('\n', stderr);
}

static int report(const struct machine *m, const struct race_reports *races, const struct arguments *a)
{
    int status = status_of(m, races);
    char *lost = flushed(stdout) ? NULL : cannot_write("standard output");
    end_line(m, races, a->quiet);
    bool found = m->outcome == MACHINE_DEADLOCK && print_mpi_checks(m); /* they may say why */
    if (m->message && !m->said)
        cli_say_error("run", "%s", m->message);
    if (!a->quiet)
        summary_print(m, races, a->verbose, stderr);
    race_print(races, stderr);
    if (m->outcome != MACHINE_DEADLOCK)
        found = print_mpi_checks(m);
    if (found && !status)
        status = EXIT_FINDINGS;
    bool complete = written(lost);
    if (a->json)
        complete &= written(summary_json(m, races, a->json));
    if (a->deadlock)
        complete &= written(write_deadlock(m->waits, a->deadlock));
    if (a->races)
        complete &= written(race_json_write(races, a->races));
    if (a->sarif)
        complete &= written(sarif_write(m, races, CLI_VERSION, a->sarif));
    if (a->profile)
        complete &= written(report_profile(m, a));
    return complete ? status : CLI_EXIT_OUTPUT;
}

static int report_with_races(const struct machine *m, const struct race_suppressions *s,
                             const struct arguments *a)
{
    struct race_reports *races = race_reports_collect(m->sys.races, s);
    int status = report(m, races, a);
    race_reports_free(races);
    return status;
}

static int unprofiled(const char *program)
{
    return input_error(
        xasprintf("--profile: %s was built without it: compile and link it with nxcc --profile", program));
}

/* The arguments are the host program's, with its name in place of the node program's: in a copy, for a trace
 * has the command as it was given. */
static void give_to_host(struct arguments *a, struct machine_options *o)
{
    const int count = a->what.program_count;
    char **words = xcalloc((size_t)count + 2, sizeof *words);
    for (int i = 1; i < count; i++)
        words[i] = a->what.program[i];
    words[0] = (char *)(uintptr_t)a->what.host;
    a->on_host = (struct named_program){.argc = count ? count : 1, .argv = words};
    o->program = count ? a->what.program[0] : NULL;
    o->programs = &a->on_host, o->program_count = 1;
}

/* A node's locale is "C", whatever the user's is: programs get the environment without that. */
static char **environment_of_programs(void)
{
    size_t count = 0, kept = 0;
    while (environ[count])
        count++;
    char **list = xcalloc(count + 1, sizeof *list);
    for (char **e = environ; *e; e++)
        if (strncmp(*e, "LC_", 3) && strncmp(*e, "LANG=", 5) && strncmp(*e, "LANGUAGE=", 9))
            list[kept++] = *e;
    return list;
}

static struct machine_options options_of(struct arguments *a, const struct cfg_machine *cfg)
{
    const struct result_paths results = results_of(a);
    struct machine_options o = {.cfg = cfg,
                                .nodes = cli_program_nodes(&a->what),
                                .programs = a->what.programs,
                                .program_count = a->what.programs_count,
                                .host = a->what.host,
                                .envp = a->environment = environment_of_programs(),
                                .max_virtual_s = a->what.max_virtual_s,
                                .max_wall_s = a->what.max_wall_s,
                                .max_unreceived = (size_t)a->what.max_unreceived_mb << 20,
                                .slice_s = a->slice_s,
                                .workers = cli_workers(a->workers),
                                .shuffle = a->shuffle,
                                .cfs_dir = a->cfs,
                                .layer = a->layer,
                                .isolate = a->isolate,
                                .mpi_checks = a->mpi_checks,
                                .until = a->timing.until,
                                .draw = a->timing.drawn ? &a->timing.draw : NULL,
                                .plan = a->plan,
                                .progress = !a->quiet && isatty(STDERR_FILENO),
                                .debugged = debugger_is_attached(),
                                .stop = a->stop,
                                .out = result_paths_dashes(&results) ? stderr : stdout,
                                .err = stderr};
    if (a->what.host)
        give_to_host(a, &o);
    return o;
}

/* From here on, touchstone starts no other program, and node programs make no system calls. */
static void refuse_system_calls(const struct arguments *a)
{
    if (!call_filter_install() && a->verbose)
        fprintf(stderr,
                "touchstone run: this kernel does not refuse system calls that programs make past the C "
                "library (seccomp: %s)\n",
                strerror(errno));
}

/* A machine cannot change the costs that nxcc has counted into a program. Times depend on them, which -q does
 * not tell. */
static void warn_of_other_costs(const struct machine *m, const struct machine_options *o, bool quiet)
{
    const char *cpu = o->cfg->cpu, *slash = strrchr(cpu, '/');
    for (size_t i = 0; i < m->image_count && !quiet && !o->host; i++) {
        char *other = node_image_other_costs(m->images[i], cpu);
        if (other)
            cli_say_warning("run",
                            "%s was compiled with the costs of %s, but %s has those of %s: nxcc --costs %s",
                            node_image_path(m->images[i]), other, o->cfg->name, slash ? slash + 1 : cpu, cpu);
        free(other);
    }
}

/* Counts of a schedule mean other messages in another program, which mostly runs to its end all the same. */
static void warn_of_other_program(const struct machine *m, const struct plan *plan)
{
    if (plan && plan->has_program && plan->program != machine_program_sum(m))
        cli_say_warning("run",
                        "%s was recorded of another program than %s, or of this one compiled otherwise: what "
                        "it counts may be something else here",
                        plan->path, node_image_path(m->images[0]));
}

struct ending {
    bool has_run;
    int signal; /* that ended the run; 0: none */
};

/* Runs the machine and reports; returns the exit status. */
static int run_machine(const struct arguments *a, const struct machine_options *o, struct run_files *files,
                       struct ending *end)
{
    char *error = NULL;
    int status;
    struct run_trace trace = {0};
    struct race_suppressions *suppressed = a->suppress ? race_suppress_read(a->suppress, &error) : NULL;
    struct machine *m = error ? NULL : machine_new(o, &error);
    if (!m) {
        race_suppress_free(suppressed);
        return input_error(error);
    }
    if (a->profile && !profile_possible(m)) {
        status = unprofiled(a->what.program[0]);
    } else if (a->trace.path && !run_trace_begin(&trace, m, &a->trace, &error)) {
        status = output_error(error);
    } else {
        warn_of_other_costs(m, o, a->quiet);
        warn_of_other_program(m, a->plan);
        refuse_system_calls(a);
        run_files_replace(files);
        machine_run(m);
        end->has_run = true;
        status = report_with_races(m, suppressed, a);
        if (trace.recorder && !run_trace_end(&trace, m, &error))
            status = output_error(error);
        debug_stop_end(&m->sys, m->outcome == MACHINE_DEADLOCK);
    }
    end->signal = m->signal;
    machine_free(m);
    race_suppress_free(suppressed);
    return status;
}

/* SIGUSR1, which asks where the nodes are, does not end a run that has not begun or is over. */
static void keep_questions(void)
{
    sigset_t one;
    sigemptyset(&one);
    sigaddset(&one, SIGUSR1);
    sigprocmask(SIG_BLOCK, &one, NULL);
}

/* Whoever reads standard output may go (touchstone run ... | head): this ends the run, as it ends other
 * programs, unless the run also has files to write. */
static void outlive_reader(const struct arguments *a)
{
    const struct result_paths results = results_of(a);
    if (result_paths_count(&results))
        signal(SIGPIPE, SIG_IGN);
}

/* Runs, and writes the files that are written as the run goes on. */
static int run_with_files(const struct arguments *a, struct machine_options *o)
{
    struct run_files files;
    struct ending end = {0};
    char *error = NULL;
    const struct result_paths results = results_of(a);
    if (!result_paths_possible(&results, &error) ||
        (error = run_files_begin(&files, a->history, a->timing.record)))
        return output_error(error);
    o->history = files.history.out, o->schedule = files.schedule.out;
    int status = run_machine(a, o, &files, &end);
    if (!end.has_run)
        run_files_drop(&files);
    else if ((error = run_files_end(&files)))
        status = output_error(error);
    if (end.signal)
        raise(end.signal); /* the parent process is to know */
    return status;
}

static int run(struct arguments *a)
{
    struct cli_installation places;
    char *error = NULL;
    keep_questions();
    outlive_reader(a);
    if (!cli_find_installation(&places, "run"))
        return CLI_EXIT_INPUT;
    if (!cli_program_find(&a->what, places.programs, a->verbose, &error))
        return input_error(error);
    struct cfg_machine *cfg = cfg_load_with(a->what.machine, places.machines, a->what.set, &error);
    if (!cfg)
        return input_error(error);
    struct fence *fence = cli_fence(&a->host_files, a->what.program + 1, a->what.program_count - 1, &error);
    int status;
    if (!fence || (a->timing.replay && !(a->plan = plan_read(a->timing.replay, &error)))) {
        status = input_error(error);
    } else {
        struct machine_options o = options_of(a, cfg);
        o.fence = fence;
        status = run_with_files(a, &o);
    }
    fence_free(fence);
    cfg_free(cfg);
    plan_free(a->plan);
    return status;
}

static const struct argp_child CHILDREN[] = {
    {&CLI_PROGRAM, 0, NULL, 0}, {&CLI_TIMING, 0, NULL, 0}, {&CLI_HOST_FILES, 0, NULL, 0}, {0}};
static const struct argp ARGP = {OPTIONS, parse, CLI_PROGRAM_ARGUMENTS, DOC, CHILDREN, NULL, NULL};

void cli_run_read(int argc, char **argv, struct cli_run_parts *parts)
{
    struct arguments a = {0};
    cli_parse(&ARGP, "touchstone run", ARGP_IN_ORDER, argc, argv, &a);
    *parts = (struct cli_run_parts){a.what, a.cfs, a.json, a.host_files.list};
    free(a.traced_nodes);
    free_layer(&a);
}

int cli_run(int argc, char **argv)
{
    struct arguments a = {0};
    char **whole = argv - 1; /* main's: "touchstone", "run", ... */
    a.trace.command = whole, a.trace.version = CLI_VERSION;
    cli_parse(&ARGP, "touchstone run", ARGP_IN_ORDER, argc, argv, &a);
    int status;
    if (a.sensitivity)
        status = cli_hand_to_lab(whole);
    else if (a.stop.wanted && !debugger_is_attached())
        status = cli_start_gdb(whole);
    else if (a.engine && cli_is_other_engine(a.engine))
        status = cli_change_engine(a.engine, whole);
    else
        status = run(&a);
    cli_program_free(&a.what);
    free(a.on_host.argv);
    free(a.environment);
    free(a.host_files.list);
    free(a.traced_nodes);
    free_layer(&a);
    return status;
}
