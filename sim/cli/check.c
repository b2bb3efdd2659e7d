/* check.c - touchstone check: studies against a baseline. */
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>

#include "cli/studies.h"
#include "lab/check/compare_gate.h"

static const char HELP[] =
    "usage: touchstone check BASELINE.json [options] STUDY...\n"
    "\n"
    "Runs studies (touchstone study --help) and compares each point with what a baseline has of it. Says which points are\n"
    "worse, by how much, and where the time of their nodes moved: by function, if the program was built with nxcc\n"
    "--profile and the study file says profile = true.\n"
    "\n"
    "      --update         make the results the baseline, and say what that changes; makes the file if it is missing\n"
    "      --tolerance T    how much worse a figure may be, such as 0.5% for all, total_s=1% or messages=10 for one;\n"
    "                       several with commas, or the option several times; default 0\n"
    "      --exact          any difference in any figure is a failure, also for the better, also in the digest\n"
    "      --junit FILE     write the results as JUnit XML too, a test case a point\n"
    "  -o, --output DIR     what runs leave goes to DIR/STUDY; default out\n"
    "  -j, --jobs JOBS      how many runs at a time; default the number of processors\n"
    "      --cache DIR, --no-cache   as in touchstone study\n"
    "\n"
    "More is worse of total_s, time_s, virtual_time_s, messages, bytes and memory_peak_bytes; less is worse of speedup and\n"
    "speed_per_node. Other figures are shown, and decide nothing unless --tolerance names them: then any difference beyond\n"
    "it is a failure. Results are exact, so that nothing needs a tolerance to be repeated.\n"
    "\n"
    "Exit status: 0 no point is worse; 1 a point is worse, missing or failed; 2 it could not be found out.\n";

enum { EXIT_WORSE = 1, EXIT_UNKNOWN = 2 };

struct arguments {
    struct gate_options gate;
    const char *cache;
    unsigned jobs;
    bool no_cache, help;
};

static int usage(const char *format, const char *about)
{
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    cli_usage("check", format, about);
#pragma GCC diagnostic pop
    return EXIT_UNKNOWN;
}

static int read_tolerance(struct arguments *a, const char *text)
{
    char *why = NULL;
    if (compare_rules_add(&a->gate.rules, text, &why))
        return 0;
    usage("--tolerance: %s", why);
    free(why);
    return EXIT_UNKNOWN;
}

static int parse(int argc, char **argv, struct arguments *a)
{
    enum { UPDATE = 256, TOLERANCE, EXACT, JUNIT, CACHE, NO_CACHE };
    static const struct option LONG[] = {
        {"update", no_argument, NULL, UPDATE},     {"tolerance", required_argument, NULL, TOLERANCE},
        {"exact", no_argument, NULL, EXACT},       {"junit", required_argument, NULL, JUNIT},
        {"output", required_argument, NULL, 'o'},  {"jobs", required_argument, NULL, 'j'},
        {"cache", required_argument, NULL, CACHE}, {"no-cache", no_argument, NULL, NO_CACHE},
        {"help", no_argument, NULL, 'h'},          {0}};
    int wrong = 0;
    *a = (struct arguments){.gate.dir = "out"};
    optind = 0;
    opterr = 0;
    for (int c; !wrong && (c = getopt_long(argc, argv, ":o:j:h", LONG, NULL)) != -1;) {
        switch (c) {
        case UPDATE:
            a->gate.update = true;
            break;
        case TOLERANCE:
            wrong = read_tolerance(a, optarg);
            break;
        case EXACT:
            a->gate.rules.exact = true;
            break;
        case JUNIT:
            a->gate.junit = optarg;
            break;
        case 'o':
            a->gate.dir = optarg;
            break;
        case 'j':
            if (!cli_jobs(optarg, &a->jobs))
                wrong = usage("-j takes a number of jobs, not '%s'", optarg);
            break;
        case CACHE:
            a->cache = optarg;
            break;
        case NO_CACHE:
            a->no_cache = true;
            break;
        case 'h':
            a->help = true;
            return 0;
        case ':':
            return usage("%s needs a value", argv[optind - 1]);
        default:
            return usage("there is no option %s", argv[optind - 1]);
        }
    }
    if (!wrong && a->gate.rules.exact && a->gate.rules.count)
        wrong = usage("--exact leaves no room for %s", "--tolerance");
    if (!wrong && argc - optind < 2)
        wrong = usage("which %s?", optind == argc ? "baseline, and which study file" : "study file");
    a->gate.baseline = argv[optind];
    a->gate.files = (const char *const *)argv + optind + (optind < argc);
    return wrong;
}

static int check(struct arguments *a)
{
    struct cli_studies s;
    char *error = NULL;
    if (!cli_studies_begin(&s, "check", a->jobs, a->cache, a->no_cache, &a->gate.study))
        return EXIT_UNKNOWN;
    a->gate.study.retry_failed = true;
    enum gate_end end = gate_run(&a->gate, &error);
    if (end == GATE_ERROR)
        fprintf(stderr, "touchstone check: %s\n", error);
    free(error);
    cli_studies_end(&s);
    return end == GATE_PASSED ? 0 : end == GATE_WORSE ? EXIT_WORSE : EXIT_UNKNOWN;
}

int cli_check(int argc, char **argv)
{
    struct arguments a;
    int status = parse(argc, argv, &a);
    if (!status)
        status = a.help ? (fputs(HELP, stdout), 0) : check(&a);
    compare_rules_clear(&a.gate.rules);
    return status;
}
