/* study.c - touchstone study: a program at all points of a study file. */
#include <getopt.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/studies.h"
#include "lab/jobs/session.h"
#include "lab/study/study_make.h"

static const char HELP[] =
    "usage: touchstone study FILE [-o DIR] [-j JOBS] [options]\n"
    "\n"
    "Runs a program once for every combination of the values of a study file's axes: numbers of nodes, numbers of the\n"
    "machine file, arguments of the program. Writes what each run came to, and draws pictures of it.\n"
    "\n"
    "  -o, --output DIR     where the results go; default out/ and FILE's name: results.json, results.csv,\n"
    "                       pictures, and findings.md: what can be read off them\n"
    "  -j, --jobs JOBS      how many runs at a time; default the number of processors; under mpirun or srun, 1\n"
    "      --retry-failed   run points again that failed before\n"
    "      --cache DIR      keep results there and take them from there, for all studies; default\n"
    "                       $XDG_CACHE_HOME/touchstone or ~/.cache/touchstone\n"
    "      --no-cache       neither\n"
    "\n"
    "Each result is in DIR/journal before the next is begun. After Ctrl-C, kill -9 or a power cut the same command goes on,\n"
    "and runs nothing twice. A point is what it depends on: the bytes of program, simulator, machine file and inputs, and\n"
    "its arguments; where one of them has changed it is run again.\n"
    "\n"
    "mpirun --enable-recovery -np 64 touchstone study FILE (or srun -n 64 ...) shares the points among 64 processes, on any\n"
    "computers that see the same folder DIR.\n"
    "\n"
    "A study file:\n"
    "  title = \"Groups\";  about = \"What is asked.\";   # for the page of findings\n"
    "  program = \"app/model\";       # beside this file, or of those that come with touchstone\n"
    "  machine = \"delta\";           # as in touchstone run -m; a path is from this file's folder\n"
    "  arguments = \"-approx 111\";   # of every run; words separated by blanks\n"
    "  inputs = ( \"volume.gz\" );    # files that the program reads, from this file's folder, where it is run\n"
    "  axes = (                     # a value's text stands for {}; nodes and machine need no more than values\n"
    "      { name = \"nodes\"; values = ( 16, 64 ); },         # or: values = { from = 16; to = 256; times = 2; };\n"
    "      { name = \"group\"; values = ( 2, 4, 8, 16, 32 ); arguments = \"-group {}\"; },\n"
    "      { name = \"interrupt\"; values = { from = 50; to = 250; step = 100; }; set = ( \"system.interrupt_us={}\" ); },\n"
    "      { name = \"hosts\"; value = \"nodes / group\";    # follows from others; its arguments and set, if any,\n"
    "        when = \"hosts > 1\"; arguments = \"-noreassign\"; },               # only where this holds\n"
    "      { name = \"output\"; cases = ( { label = \"none\"; }, { label = \"files\"; arguments = \"-parts /cfs/p\"; } ); }\n"
    "  );\n"
    "  only = ( \"group <= nodes\" ); # points for which one of these does not hold are left out; && || ! + - * / % ^\n"
    "                               # min max floor ceil round sqrt log2 abs if(c, a, b) are known\n"
    "  cost = \"nodes * nodes\";      # how long a point takes, in any unit: the longest are begun first; default nodes\n"
    "  max_wall_s = 60.0;           # a point that takes longer has failed; also max_virtual_s\n"
    "  profile = true;              # where the time of each point went, by function; for a program built with --profile\n"
    "  pictures = (                 # default: time, idle time, speed-up and speed per node against nodes\n"
    "      { file = \"time\"; x = \"group\"; y = \"total_s\"; lines = \"output\"; panels = \"nodes\"; ... },\n"
    "      { file = \"best\"; x = \"nodes\"; best = \"group\"; least = \"total_s\"; lines = \"output\"; ... }\n"
    "  );                           # also title, x_label, y_label, logarithmic = \"xy\"\n"
    "\n"
    "Figures are the lines \"key value\" that the program prints and those of touchstone run --json; all are in\n"
    "results.csv. Each run has a Concurrent File System of its own, which is gone after it.\n"
    "\n"
    "Exit status: 0 every point is there; 1 a point or a picture failed (named, the rest is there); 64 wrong arguments;\n"
    "65 the study file cannot be used, or the results not written; 128 and more: stopped by that signal.\n";

enum { EXIT_INPUT = 65 };

struct arguments {
    const char *file, *dir, *cache;
    unsigned jobs;
    bool no_cache, retry_failed, help;
};

static int parse(int argc, char **argv, struct arguments *a)
{
    enum { CACHE = 256, NO_CACHE, RETRY_FAILED };
    static const struct option LONG[] = {{"output", required_argument, NULL, 'o'},
                                         {"cache", required_argument, NULL, CACHE},
                                         {"no-cache", no_argument, NULL, NO_CACHE},
                                         {"retry-failed", no_argument, NULL, RETRY_FAILED},
                                         {"jobs", required_argument, NULL, 'j'},
                                         {"help", no_argument, NULL, 'h'},
                                         {0}};
    *a = (struct arguments){0};
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
        case CACHE:
            a->cache = optarg;
            break;
        case NO_CACHE:
            a->no_cache = true;
            break;
        case RETRY_FAILED:
            a->retry_failed = true;
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

/* Of several processes the first speaks for all, but for what goes wrong. */
static FILE *silence(void)
{
    FILE *nowhere = fopen("/dev/null", "we");
    return nowhere ? nowhere : stderr;
}

static int study(const struct arguments *a, struct study_options *o)
{
    struct session t = session_find();
    char *error = NULL;
    int signal = 0;
    o->session = t.name;
    o->at_once = a->jobs ? a->jobs : t.count > 1 ? 1 : cli_processors();
    if (t.rank > 0)
        o->progress = silence();
    enum study_end end = study_make(o, &signal, &error);
    if (end == STUDY_ERROR) {
        if (t.count > 1)
            fprintf(stderr, "touchstone study, process %u of %u: %s\n", t.rank, t.count, error);
        else
            fprintf(stderr, "touchstone study: %s\n", error);
        free(error);
    }
    if (o->progress != stderr)
        fclose(o->progress);
    return end == STUDY_DONE         ? 0
           : end == STUDY_INCOMPLETE ? 1
           : end == STUDY_STOPPED    ? 128 + signal
                                     : EXIT_INPUT;
}

int cli_study(int argc, char **argv)
{
    struct arguments a;
    struct cli_studies s;
    struct study_options options;
    char dir[PATH_MAX];
    int wrong = parse(argc, argv, &a);
    if (wrong)
        return wrong;
    if (a.help)
        return fputs(HELP, stdout), 0;
    if (!cli_studies_begin(&s, "study", a.jobs, a.cache, a.no_cache, &options))
        return EXIT_INPUT;
    cli_studies_folder(a.file, "", dir);
    options.file = a.file;
    options.dir = a.dir ? a.dir : dir;
    options.retry_failed = a.retry_failed;
    int status = study(&a, &options);
    cli_studies_end(&s);
    return status;
}
