/* run.c - touchstone run: one program on one machine. */
#include <errno.h>
#include <signal.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "cli/cli.h"
#include "files/atomic_file.h"
#include "machine/machine.h"
#include "observe/profile.h"
#include "observe/summary.h"

static const char HELP[] =
    "usage: touchstone run [-m MACHINE] [-n NODES] [options] PROGRAM [ARGS...]\n"
    "       touchstone run --host HOST [-m MACHINE] [-n NODES] [options] [PROGRAM [ARGS...]]\n"
    "\n"
    "Runs PROGRAM, built by nxcc, on every node of a simulated machine. What the nodes print comes out on "
    "standard\n"
    "output in the order of virtual time; a summary follows on standard error.\n"
    "\n"
    "  -m MACHINE              a machine file (machines/NAME.cfg by its NAME, or a path); default delta\n"
    "  -n NODES                how many nodes; default 1\n"
    "  --host HOST             run HOST, built by nxcc -host, on the machine's host; it loads the nodes itself: "
    "load(\"x\")\n"
    "                          finds PROGRAM by its name, or a program x beside HOST. ARGS are HOST's. MACHINE is "
    "ipsc860\n"
    "                          by default; with -n HOST has its nodes from the start, without it calls getcube\n"
    "  --set KEY=VALUE         a number of the machine file by its dotted path, instead of the file's, such as\n"
    "                          system.interrupt_us=150; may be given several times\n"
    "  --cfs DIR               the files of /cfs are those of this folder (made if missing); without it, of "
    "a\n"
    "                          temporary one that is gone after the run\n"
    "  --json FILE             write the figures of the run, per node too, as JSON\n"
    "  --profile FILE          write as JSON where the nodes' time went, by function, and show the dearest "
    "functions;\n"
    "                          for a PROGRAM built with nxcc --profile\n"
    "  --max-virtual-time S    stop when a node passes S seconds of virtual time\n"
    "  --max-wall-time S       stop after S seconds of real time\n"
    "  --slice S               look at computing programs at least every S virtual seconds: results must "
    "not\n"
    "                          depend on it, and this is how to test that\n"
    "  --isolate               stop a program that writes into another node's memory, and say where; one thread, and\n"
    "                          slower by some microseconds for each switch from node to node\n"
    "  -w, --workers N         compute with N threads; default TOUCHSTONE_WORKERS, else as many as processors, at\n"
    "                          most 8. Results do not depend on it\n"
    "  --shuffle SEED          let the threads take turns at random, which is how to test that\n"
    "  --engine ENGINE         'reference': by the rules of time in their plainest form, which define all results; slow. "
    "Or\n"
    "                          'fast', the default, which has to give the same. TOUCHSTONE_ENGINE=reference in the\n"
    "                          environment does that for all commands of touchstone\n"
    "  --history FILE          write a line for each message received, in order: picoseconds, sender, receiver, type,\n"
    "                          length. The digest is made of these\n"
    "  -q, --quiet             no summary\n"
    "\n"
    "Exit status: 0 all programs ended; 1 a program crashed, ended with an error, ran out of memory, or a "
    "limit\n"
    "was reached; 2 deadlock: every program waits and no message is under way; 64 wrong arguments;\n"
    "65 the machine or program cannot be used; 74 standard output or a result cannot be written. A run that is ended "
    "by\n"
    "SIGINT, SIGTERM or SIGHUP reports where each node is, and then ends by that signal.\n"
    "\n"
    "example: nxcc -O2 -o ring ring.c && touchstone run -m ipsc860 -n 16 ring\n";

enum { EXIT_USAGE = 64, EXIT_INPUT = 65, EXIT_OUTPUT = 74, MOST_WORKERS = 256, USUAL_WORKERS = 8 };

struct arguments {
    const char *machine, *json, *profile, *history, *cfs, *host, *engine;
    const char **set; /* ended by NULL */
    uint32_t nodes, workers, shuffle;
    double max_virtual_s, max_wall_s, slice_s;
    bool quiet, help, isolate;
    char **program;
    int program_count;
};

static bool positive(const char *text, double *value)
{
    char *end;
    *value = strtod(text, &end);
    return *text && !*end && *value > 0;
}

static bool whole(const char *text, uint32_t *value)
{
    double x;
    if (!positive(text, &x) || x != (double)(uint32_t)x)
        return false;
    *value = (uint32_t)x;
    return true;
}

/* 0, or the exit status for wrong arguments. */
static int parse(int argc, char **argv, struct arguments *a)
{
    enum {
        JSON = 256,
        MAX_VIRTUAL,
        MAX_WALL,
        SLICE,
        CFS,
        SET,
        PROFILE,
        SHUFFLE,
        HOST,
        HISTORY,
        ENGINE,
        ISOLATE
    };
    static const struct option LONG[] = {{"json", required_argument, NULL, JSON},
                                         {"profile", required_argument, NULL, PROFILE},
                                         {"engine", required_argument, NULL, ENGINE},
                                         {"isolate", no_argument, NULL, ISOLATE},
                                         {"history", required_argument, NULL, HISTORY},
                                         {"host", required_argument, NULL, HOST},
                                         {"set", required_argument, NULL, SET},
                                         {"cfs", required_argument, NULL, CFS},
                                         {"max-virtual-time", required_argument, NULL, MAX_VIRTUAL},
                                         {"max-wall-time", required_argument, NULL, MAX_WALL},
                                         {"slice", required_argument, NULL, SLICE},
                                         {"machine", required_argument, NULL, 'm'},
                                         {"nodes", required_argument, NULL, 'n'},
                                         {"workers", required_argument, NULL, 'w'},
                                         {"shuffle", required_argument, NULL, SHUFFLE},
                                         {"quiet", no_argument, NULL, 'q'},
                                         {"help", no_argument, NULL, 'h'},
                                         {0}};
    size_t set = 0;
    *a = (struct arguments){.set = calloc((size_t)argc + 1, sizeof *a->set)};
    if (!a->set)
        abort();
    optind = 0;
    opterr = 0;
    for (int c; (c = getopt_long(argc, argv, "+:m:n:w:qh", LONG, NULL)) != -1;) {
        switch (c) {
        case 'm':
            a->machine = optarg;
            break;
        case 'n':
            if (!whole(optarg, &a->nodes))
                return cli_usage("run", "-n takes a number of nodes, 1 or more, not '%s'", optarg);
            break;
        case 'w':
            if (!whole(optarg, &a->workers) || a->workers > MOST_WORKERS)
                return cli_usage("run", "-w takes a number of threads, 1 to %d, not '%s'", MOST_WORKERS,
                                 optarg);
            break;
        case SHUFFLE:
            if (!whole(optarg, &a->shuffle))
                return cli_usage("run", "--shuffle takes a seed, 1 or more, not '%s'", optarg);
            break;
        case JSON:
            a->json = optarg;
            break;
        case PROFILE:
            a->profile = optarg;
            break;
        case HOST:
            a->host = optarg;
            break;
        case ENGINE:
            if (strcmp(optarg, "fast") && strcmp(optarg, "reference"))
                return cli_usage("run", "--engine takes 'fast' or 'reference', not '%s'", optarg);
            a->engine = optarg;
            break;
        case ISOLATE:
            a->isolate = true;
            break;
        case HISTORY:
            a->history = optarg;
            break;
        case CFS:
            a->cfs = optarg;
            break;
        case SET:
            if (!strchr(optarg, '=') || *optarg == '=')
                return cli_usage("run", "--set takes KEY=VALUE, such as system.interrupt_us=150, not '%s'",
                                 optarg);
            a->set[set++] = optarg;
            break;
        case MAX_VIRTUAL:
            if (!positive(optarg, &a->max_virtual_s))
                return cli_usage("run", "--max-virtual-time takes seconds, more than 0, not '%s'", optarg);
            break;
        case MAX_WALL:
            if (!positive(optarg, &a->max_wall_s))
                return cli_usage("run", "--max-wall-time takes seconds, more than 0, not '%s'", optarg);
            break;
        case SLICE:
            if (!positive(optarg, &a->slice_s))
                return cli_usage("run", "--slice takes seconds, more than 0, not '%s'", optarg);
            break;
        case 'q':
            a->quiet = true;
            break;
        case 'h':
            a->help = true;
            return 0;
        case ':':
            return cli_usage("run", "%s needs a value", argv[optind - 1]);
        default:
            return cli_usage("run", "there is no option %s", argv[optind - 1]);
        }
    }
    a->program = argv + optind;
    a->program_count = argc - optind;
    a->machine = a->machine ? a->machine : a->host ? "ipsc860" : "delta";
    if (a->host && a->profile)
        return cli_usage("run",
                         "--profile is for programs that are on all nodes from the start, not with --host");
    if (a->host)
        return 0;
    a->nodes = a->nodes ? a->nodes : 1;
    return a->program_count ? 0 : cli_usage("run", "which program? (built by nxcc)");
}

static int input_error(char *error)
{
    fprintf(stderr, "touchstone run: %s\n", error);
    free(error);
    return EXIT_INPUT;
}

static int output_error(char *error)
{
    input_error(error);
    return EXIT_OUTPUT;
}

static char *cannot_write(const char *path)
{
    char *error;
    if (asprintf(&error, "%s cannot be written: %s", path, strerror(errno)) < 0)
        abort();
    return error;
}

/* Has all that was written there arrived? Else errno says why not. */
static bool flushed(FILE *f)
{
    errno = 0;
    bool good = fflush(f) == 0 && !ferror(f);
    errno = good || errno ? errno : ENOSPC; /* an earlier write failed, whose errno is gone */
    return good;
}

/* Shows and writes it. NULL, or an error. */
static char *report_profile(const struct machine *m, const struct arguments *a)
{
    struct profile p = profile_collect(m);
    if (!a->quiet)
        profile_print(&p, stderr);
    char *error = profile_json(&p, m, a->profile);
    profile_free(&p);
    return error;
}

static int report(const struct machine *m, const struct arguments *a)
{
    int status = m->outcome == MACHINE_ENDED ? 0 : m->outcome == MACHINE_DEADLOCK ? 2 : 1;
    char *lost = flushed(stdout) ? NULL : cannot_write("standard output");
    if (m->message)
        fprintf(stderr, "touchstone run: %s\n", m->message);
    if (!a->quiet)
        summary_print(m, stderr);
    char *error = a->json ? summary_json(m, a->json) : NULL;
    if (!error && a->profile)
        error = report_profile(m, a);
    int result = lost ? output_error(lost) : 0;
    if (error)
        result = output_error(error);
    return result ? result : status;
}

static int unprofiled(const char *program)
{
    char *error;
    if (asprintf(&error, "--profile: %s was built without it: compile and link it with nxcc --profile",
                 program) < 0)
        abort();
    return input_error(error);
}

/* The host program gets the arguments, its own name in place of the node program's, if that is given. */
static void give_host(struct machine_options *o, const struct arguments *a)
{
    static char *only[2];
    o->program = a->program_count ? a->program[0] : NULL;
    o->argc = a->program_count ? a->program_count : 1;
    o->argv = a->program_count ? a->program : only;
    o->argv[0] = (char *)(uintptr_t)a->host;
}

static unsigned workers(const struct arguments *a)
{
    unsigned processors = cli_processors();
    const char *told = getenv("TOUCHSTONE_WORKERS");
    uint32_t n;
    if (a->workers)
        return a->workers;
    if (told && whole(told, &n) && n <= MOST_WORKERS)
        return n;
    return processors < USUAL_WORKERS ? processors : USUAL_WORKERS;
}

static int run(const struct arguments *a)
{
    char home[4096], machines[4128], *error = NULL;
    if (!cfg_home(home, sizeof home))
        return input_error(
            strdup("machines/ is not where this program was built or installed; set TOUCHSTONE_HOME"));
    snprintf(machines, sizeof machines, "%s/machines", home);
    struct cfg_machine *cfg = cfg_load_with(a->machine, machines, a->set, &error);
    if (!cfg)
        return input_error(error);
    extern char **environ;
    struct machine_options o = {.cfg = cfg,
                                .nodes = a->nodes,
                                .argc = a->program_count,
                                .argv = a->program,
                                .host = a->host,
                                .envp = environ,
                                .max_virtual_s = a->max_virtual_s,
                                .max_wall_s = a->max_wall_s,
                                .slice_s = a->slice_s,
                                .workers = workers(a),
                                .shuffle = a->shuffle,
                                .cfs_dir = a->cfs,
                                .isolate = a->isolate,
                                .out = stdout,
                                .err = stderr};
    if (a->host)
        give_host(&o, a);
    struct atomic_file history;
    if (a->history && !atomic_file_begin(&history, a->history, &error)) {
        cfg_free(cfg);
        return output_error(error);
    }
    o.history = a->history ? history.out : NULL;
    struct machine *m = machine_new(&o, &error);
    int status;
    if (!m) {
        status = input_error(error);
    } else if (a->profile && !profile_possible(m)) {
        status = unprofiled(a->program[0]);
    } else {
        machine_run(m);
        status = report(m, a);
    }
    int ended_by = m ? m->signal : 0;
    machine_free(m);
    cfg_free(cfg);
    if (o.history && !atomic_file_end(&history, &error))
        return output_error(error);
    if (ended_by)
        raise(ended_by); /* whoever waits for us is to know */
    return status;
}

int cli_run(int argc, char **argv)
{
    struct arguments a;
    int status = parse(argc, argv, &a);
    if (!status && !a.help && a.engine && cli_is_other_engine(a.engine)) {
        free(a.set);
        return cli_change_engine(a.engine, argv - 1); /* main's: "touchstone", "run", ... */
    }
    if (!status)
        status = a.help ? (fputs(HELP, stdout), 0) : run(&a);
    free(a.set);
    return status;
}
