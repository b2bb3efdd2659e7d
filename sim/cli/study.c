/* study.c - touchstone study: a program at all points of a study file. */
#include <getopt.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/cli.h"
#include "study/study.h"

static const char HELP[] =
    "usage: touchstone study FILE [-o DIR] [-j JOBS]\n"
    "\n"
    "Runs a program once for every combination of the values of a study file's axes: numbers of nodes, numbers of the\n"
    "machine file, arguments of the program. Writes what each run came to, and draws pictures of it.\n"
    "\n"
    "  -o, --output DIR     where the results go; default out/ and FILE's name: results.json, results.csv, pictures\n"
    "  -j, --jobs JOBS      how many runs at a time; default the number of processors\n"
    "\n"
    "A study file:\n"
    "  title = \"Groups\";\n"
    "  program = \"app/model\";       # beside this file, or of those that come with touchstone\n"
    "  machine = \"delta\";           # as in touchstone run -m\n"
    "  arguments = \"-approx 111\";   # of every run; words separated by blanks\n"
    "  axes = (                     # a value's text stands for {}; nodes and machine need no more than values\n"
    "      { name = \"nodes\"; values = ( 16, 64 ); },\n"
    "      { name = \"group\"; values = ( 2, 4, 8, 16, 32 ); arguments = \"-group {}\"; },\n"
    "      { name = \"interrupt\"; values = ( 50, 210 ); set = ( \"system.interrupt_us={}\" ); },\n"
    "      { name = \"output\"; cases = ( { label = \"none\"; }, { label = \"files\"; arguments = \"-parts /cfs/p\"; } ); }\n"
    "  );\n"
    "  only = ( \"group <= nodes\" ); # points for which one of these does not hold are left out\n"
    "  pictures = (\n"
    "      { file = \"time\"; x = \"group\"; y = \"total_s\"; lines = \"output\"; panels = \"nodes\"; ... },\n"
    "      { file = \"best\"; x = \"nodes\"; best = \"group\"; least = \"total_s\"; lines = \"output\"; ... }\n"
    "  );                           # also title, x_label, y_label, logarithmic = \"xy\"\n"
    "\n"
    "Figures are the lines \"key value\" that the program prints and those of touchstone run --json; all are in\n"
    "results.csv. Each run has a Concurrent File System of its own, which is gone after it.\n"
    "\n"
    "Exit status: 0 every point is there; 1 a point or a picture failed (named, the rest is there); 64 wrong arguments;\n"
    "65 the study file cannot be used, or the results not written.\n";

enum { EXIT_INPUT = 65 };

struct arguments {
    const char *file, *dir;
    unsigned jobs;
    bool help;
};

static int parse(int argc, char **argv, struct arguments *a)
{
    static const struct option LONG[] = {{"output", required_argument, NULL, 'o'},
                                         {"jobs", required_argument, NULL, 'j'},
                                         {"help", no_argument, NULL, 'h'},
                                         {0}};
    *a = (struct arguments){.jobs = cli_processors()};
    optind = 0;
    opterr = 0;
    for (int c; (c = getopt_long(argc, argv, ":o:j:h", LONG, NULL)) != -1;) {
        switch (c) {
        case 'o':
            a->dir = optarg;
            break;
        case 'j':
            if (!cli_jobs(optarg, &a->jobs))
                return cli_usage("study", "-j takes a number from 1 to %d, not '%s'", CLI_MAX_JOBS, optarg);
            break;
        case 'h':
            a->help = true;
            return 0;
        case ':':
            return cli_usage("study", "%s needs a value", argv[optind - 1]);
        default:
            return cli_usage("study", "there is no option %s", argv[optind - 1]);
        }
    }
    if (optind == argc)
        return cli_usage("study", "which study file?");
    a->file = argv[optind++];
    return optind == argc ? 0 : cli_usage("study", "'%s' is one argument too many", argv[optind]);
}

/* out/NAME for .../NAME.cfg */
static void name_directory(const char *file, char dir[PATH_MAX])
{
    const char *slash = strrchr(file, '/'), *name = slash ? slash + 1 : file, *dot = strrchr(name, '.');
    snprintf(dir, PATH_MAX, "out/%.*s", (int)(dot && dot > name ? (size_t)(dot - name) : strlen(name)), name);
}

int cli_study(int argc, char **argv)
{
    struct arguments a;
    char runner[PATH_MAX], programs[CLI_MAX_PROGRAMS], dir[PATH_MAX], *error = NULL;
    int wrong = parse(argc, argv, &a);
    if (wrong)
        return wrong;
    if (a.help)
        return fputs(HELP, stdout), 0;
    if (!cli_find_programs(runner, programs))
        return fputs("touchstone study: /proc/self/exe cannot be read\n", stderr), EXIT_INPUT;
    name_directory(a.file, dir);
    struct study_options options = {.file = a.file,
                                    .runner = runner,
                                    .programs = programs,
                                    .dir = a.dir ? a.dir : dir,
                                    .at_once = a.jobs,
                                    .out = stdout,
                                    .progress = stderr};
    enum study_end end = study_make(&options, &error);
    if (end == STUDY_ERROR) {
        fprintf(stderr, "touchstone study: %s\n", error);
        free(error);
    }
    return end == STUDY_DONE ? 0 : end == STUDY_INCOMPLETE ? 1 : EXIT_INPUT;
}
