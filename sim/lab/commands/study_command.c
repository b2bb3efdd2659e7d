/* study_command.c - touchstone study: a program at all points of a study file. */
#include <stdio.h>
#include <stdlib.h>
#include "lab/commands/lab_commands.h"
#include "cli/say.h"
#include "lab/commands/study_session.h"
#include "kernel/xalloc.h"
#include "lab/jobs/session.h"
#include "lab/study/study_make.h"

struct arguments {
    struct cli_study_arguments study;
    bool retry_failed;
};

static const struct argp_option OPTIONS[] = {
    {"output", 'o', "DIR", 0, "Folder for results, pictures and findings.md; default out/ and FILE's name",
     1},
    {"retry-failed", CLI_FLAG(arguments, retry_failed), NULL, 0, "Run again the points that failed before",
     1},
    {0}};

static const char DOC[] =
    "Runs a program once for every combination of the values of a study file's axes: numbers of nodes, "
    "numbers of the machine file, arguments of the program. Writes each run's results, and draws pictures "
    "of them.\v"
    "Files in DIR: findings.md, a page with tables and pictures; results.csv and results.json, all figures; "
    "the pictures; and journal.\n\n"
    "Each result is in DIR/journal before the next run begins. After Ctrl-C, kill -9 or a power cut the "
    "same command continues, and runs no point twice. A point depends on the bytes of program, simulator, "
    "machine file and inputs, and on its arguments; it is run again when one of them has changed.\n\n"
    "mpirun --enable-recovery -np 64 touchstone study FILE (or srun -n 64 ...) shares the points among 64 "
    "processes, on any computers that see the same folder DIR. Each then runs one point at a time by "
    "default.\n\n"
    "A study file:\n"
    "  title = \"Groups\"; about = \"What is asked.\"; # for the page of findings\n"
    "  program = \"app/model\";     # beside this file, or one that touchstone brings\n"
    "  machine = \"delta\";         # default delta; a path: from this file's folder\n"
    "  arguments = \"-approx 111\"; # of every run; words separated by blanks\n"
    "  inputs = ( \"volume.gz\" );  # files that the program reads, from this file's\n"
    "                             # folder, which is the program's current one\n"
    "  axes = ( # {} is replaced by the value; nodes and machine need only values.\n"
    "           # Without an axis nodes, nodes = N; is of all points; default 1\n"
    "    { name = \"nodes\"; values = ( 16, 64 ); },\n"
    "    # or values = { from = 16; to = 256; times = 2; };\n"
    "    { name = \"group\"; values = ( 2, 4, 8, 16 ); arguments = \"-group {}\"; },\n"
    "    { name = \"interrupt\"; values = { from = 50; to = 250; step = 100; };\n"
    "      set = ( \"system.interrupt_us={}\" ); },\n"
    "    # follows from others; its arguments and set apply only where `when` holds\n"
    "    { name = \"hosts\"; value = \"nodes / group\";\n"
    "      when = \"hosts > 1\"; arguments = \"-noreassign\"; },\n"
    "    { name = \"output\"; cases = ( { label = \"none\"; },\n"
    "      { label = \"files\"; arguments = \"-parts /cfs/p\"; } ); }\n"
    "  );\n"
    "  # a point for which one of these does not hold is left out; there are also\n"
    "  # && || ! + - * / % ^ min max floor ceil round sqrt log2 abs if(c, a, b)\n"
    "  only = ( \"group <= nodes\" );\n"
    "  cost = \"nodes * nodes\";    # the costliest points run first; default nodes\n"
    "  baseline = ( \"group=8\",    # speed-ups are against a point of group 8,\n"
    "               \"image\" );   # each image's against one of that image; default:\n"
    "                             # the fewest nodes, and of these the least time\n"
    "  max_wall_s = 60.0;         # a longer point fails; also max_virtual_s,\n"
    "                             # max_unreceived_mb; default as in touchstone run\n"
    "  profile = true;            # time by function, as by run --profile\n"
    "  pictures = ( # default: time, idle time, speed-up, speed per node; by nodes\n"
    "    { file = \"time\"; x = \"group\"; y = \"total_s\"; lines = \"output\";\n"
    "      panels = \"nodes\"; title = \"Time\"; x_label = \"nodes\"; y_label = \"s\";\n"
    "      logarithmic = \"xy\"; ranges = \"own\"; }, # default: all have the same\n"
    "    # the figure at the axis's second value divided by that at its first\n"
    "    { file = \"files\"; x = \"nodes\"; y = \"total_s\"; ratio = \"output\";\n"
    "      lines = \"group\"; lines_label = \"nodes in a group\"; }, # or panels_label\n"
    "    { file = \"best\"; x = \"nodes\"; best = \"group\"; least = \"total_s\"; }\n"
    "  );\n\n"
    "Figures are the lines \"key value\" that the program prints, and the figures of touchstone run "
    "--json; results.csv has them all. time_s, of which speed-ups are, is total_s if the program prints it, "
    "else virtual_time_s. Each run has a Concurrent File System of its own, which is deleted "
    "after it.\n\n"
    "Exit status:\n"
    "  0    every point has its results\n"
    "  1    a point or a picture failed; it is named, and all others are there\n"
    "  64   wrong arguments\n"
    "  65   the study file cannot be used, or the results not written\n"
    "  128  and more: stopped by the signal of that number less 128\n\n"
    "Example:\n"
    "  touchstone study groups.cfg -o out/groups -j 4";

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (key == ARGP_KEY_INIT)
        state->child_inputs[0] = &a->study.session;
    else
        return cli_study_argument(key, arg, state, &a->study);
    return 0;
}

static int study(const struct arguments *a, struct study_options *o)
{
    struct session t = session_find();
    char *error = NULL;
    int signal = 0;
    o->session = t.name;
    if (t.count > 1 && !a->study.session.jobs)
        o->at_once = 1;
    if (t.rank > 0)
        cli_session_silence(o); /* the first process shows the progress of all */
    enum study_end end = study_make(o, &signal, &error);
    if (end == STUDY_ERROR) {
        char *command =
            t.count > 1 ? xasprintf("study, process %u of %u", t.rank, t.count) : xstrdup("study");
        cli_failed(command, error, 0);
        free(command);
    }
    return end == STUDY_DONE         ? 0
           : end == STUDY_INCOMPLETE ? 1
           : end == STUDY_STOPPED    ? 128 + signal
                                     : CLI_EXIT_INPUT;
}

int cli_study(int argc, char **argv)
{
    static const struct argp_child CHILDREN[] = {{&CLI_SESSION, 0, NULL, 0}, {0}};
    static const struct argp ARGP = {OPTIONS, parse, "FILE", DOC, CHILDREN, NULL, NULL};
    struct arguments a = {0};
    struct cli_session s;
    struct study_options options;
    char dir[PATH_MAX];
    cli_parse(&ARGP, "touchstone study", 0, argc, argv, &a);
    if (!cli_session_begin(&s, "study", &a.study.session, &options))
        return CLI_EXIT_INPUT;
    cli_default_folder(a.study.file, "", dir);
    options.file = a.study.file;
    options.dir = a.study.dir ? a.study.dir : dir;
    options.retry_failed = a.retry_failed;
    int status = study(&a, &options);
    cli_session_end(&s, &options);
    return status;
}
