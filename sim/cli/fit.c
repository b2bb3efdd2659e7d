/* fit.c - touchstone fit: numbers of the machine or of the program, so that a study comes near measurements. */
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/studies.h"
#include "lab/fit/fit.h"

static const char HELP[] =
    "usage: touchstone fit STUDY [options]\n"
    "\n"
    "Looks for the numbers of a machine, or of a program's arguments, with which the points of a study come nearest to\n"
    "measurements, in the sense of least squares. Says how sensitive each figure is to each number, and which numbers the\n"
    "measurements do not determine.\n"
    "\n"
    "  --constants FILE     what was fitted, with its provenance; default DIR/fitted.cfg\n"
    "  --most N             how many evaluations of all points the search may take; default 200\n"
    "  -o, --output DIR     what runs leave; default out/ and STUDY's name and -fit\n"
    "  -j, --jobs JOBS      how many runs at a time; default the number of processors\n"
    "  --cache DIR, --no-cache   as in touchstone study; an interrupted fit, given again, goes on from where it was\n"
    "\n"
    "The study file has, beside what touchstone study takes:\n"
    "  fit = {\n"
    "      parameters = (\n"
    "          { name = \"latency\"; set = \"net.latency_us={}\"; from = 10.0; to = 200.0; start = 50.0; },\n"
    "          { name = \"k\"; arguments = \"-k {}\"; from = 1.0; to = 4.0; logarithmic = true; }\n"
    "                                    # or factor = \"slice.c\": then build = \"nxcc -O2 --factors {factors} -o {program} a.c\"\n"
    "      );                            # without start from the middle\n"
    "      measurements = \"measured.csv\"; # a line of names: axes, figures, weight; then lines of values\n"
    "      weights = \"relative\";         # or \"rounding\": in halves of a unit of the last digit\n"
    "  };\n"
    "\n"
    "Exit status: 0 all numbers are determined; 1 some are not (named); 64 wrong arguments; 65 it cannot be done.\n";

enum { EXIT_UNDETERMINED = 1, EXIT_INPUT = 65 };

struct arguments {
    const char *file, *constants, *dir, *cache;
    unsigned jobs, most;
    bool no_cache, help;
};

static bool read_most(const char *text, unsigned *most)
{
    char *end;
    long number = strtol(text, &end, 10);
    *most = (unsigned)number;
    return *text && !*end && number >= 1 && number <= 1000000;
}

static int parse(int argc, char **argv, struct arguments *a)
{
    enum { CONSTANTS = 256, MOST, CACHE, NO_CACHE };
    static const struct option LONG[] = {{"constants", required_argument, NULL, CONSTANTS},
                                         {"most", required_argument, NULL, MOST},
                                         {"output", required_argument, NULL, 'o'},
                                         {"jobs", required_argument, NULL, 'j'},
                                         {"cache", required_argument, NULL, CACHE},
                                         {"no-cache", no_argument, NULL, NO_CACHE},
                                         {"help", no_argument, NULL, 'h'},
                                         {0}};
    *a = (struct arguments){.most = 200};
    optind = 0;
    opterr = 0;
    for (int c; (c = getopt_long(argc, argv, ":o:j:h", LONG, NULL)) != -1;) {
        switch (c) {
        case CONSTANTS:
            a->constants = optarg;
            break;
        case MOST:
            if (!read_most(optarg, &a->most))
                return cli_usage("fit", "--most takes a number from 1 to 1000000, not '%s'", optarg);
            break;
        case 'o':
            a->dir = optarg;
            break;
        case 'j':
            if (!cli_jobs(optarg, &a->jobs))
                return cli_usage("fit", "-j takes a number from 1 to %d, not '%s'", CLI_MAX_JOBS, optarg);
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
            return cli_usage("fit", "%s needs a value", argv[optind - 1]);
        default:
            return cli_usage("fit", "there is no option %s", argv[optind - 1]);
        }
    }
    if (optind == argc)
        return cli_usage("fit", "which study file?");
    a->file = argv[optind++];
    return optind == argc ? 0 : cli_usage("fit", "'%s' is one argument too many", argv[optind]);
}

/* On a terminal the studies' live line is seen between ours; elsewhere their lines would hide ours. */
static FILE *studies_progress(void)
{
    FILE *nowhere = isatty(STDERR_FILENO) ? NULL : fopen("/dev/null", "we");
    return nowhere ? nowhere : stderr;
}

static int fit(const struct arguments *a, struct fit_options *o)
{
    char dir[PATH_MAX], constants[PATH_MAX + 16], *error = NULL;
    cli_studies_folder(a->file, "-fit", dir);
    o->study.file = a->file;
    o->study.dir = a->dir ? a->dir : dir;
    o->study.progress = studies_progress();
    snprintf(constants, sizeof constants, "%s/fitted.cfg", o->study.dir);
    o->constants = a->constants ? a->constants : constants;
    enum fit_end end = fit_run(o, &error);
    if (end == FIT_ERROR)
        fprintf(stderr, "touchstone fit: %s\n", error);
    free(error);
    if (o->study.progress != stderr)
        fclose(o->study.progress);
    return end == FIT_DONE ? 0 : end == FIT_UNDETERMINED ? EXIT_UNDETERMINED : EXIT_INPUT;
}

int cli_fit(int argc, char **argv)
{
    struct arguments a;
    struct cli_studies s;
    int wrong = parse(argc, argv, &a);
    if (wrong)
        return wrong;
    if (a.help)
        return fputs(HELP, stdout), 0;
    struct fit_options o = {.most = a.most, .out = stdout, .progress = stderr};
    if (!cli_studies_begin(&s, "fit", a.jobs, a.cache, a.no_cache, &o.study))
        return EXIT_INPUT;
    int status = fit(&a, &o);
    cli_studies_end(&s);
    return status;
}
