/* sensitivity_command.c - touchstone run --sensitivity: the run itself, as without that option, and then the
 * re-runs, whose output nobody sees. */
#include <errno.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include "cli/say.h"
#include "files/atomic_file.h"
#include "files/folder_make.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/commands/lab_commands.h"
#include "lab/commands/run_again.h"
#include "lab/commands/standard_input.h"
#include "lab/jobs/own_folder.h"
#include "files/words.h"
#include "lab/sensitivity/sensitivity_report.h"
#include "observe/json_file.h"

enum { EXIT_FINDINGS = 3 };

/* What is asked for, and the files of the runs. */
struct work {
    struct cli_installation places;
    struct cli_run_parts parts;
    struct run_again again;
    struct sensitivity *sensitivity;
    struct rerun_place place;
    char *folder, *json, *input; /* json: of the run itself */
    char *own_folders;           /* where those of the re-runs are */
    char **argv;                 /* the command of the run itself */
    int killed_by;               /* the signal that ended the run itself; 0: none */
};

static int failed(char *error, int status)
{
    return cli_failed("run", error, status);
}

/* --- the run itself ------------------------------------------------------------------------------------- */

/* The command without --sensitivity, which may be abbreviated, and with its figures into our file. */
static char **run_argv(const struct work *w, int argc, char **argv)
{
    char **to = xcalloc((size_t)argc + 4, sizeof *to), **word = to;
    int options = argc - w->parts.what.program_count;
    bool ended = options > 1 && !strcmp(argv[options - 1], "--");
    *word++ = (char *)(uintptr_t)w->places.runner;
    for (int i = 0; i < options - ended; i++)
        if (strncmp(argv[i], "--sen", 5) != 0)
            *word++ = argv[i];
    *word++ = (char *)(uintptr_t) "--json", *word++ = w->json;
    for (int i = options - ended; i < argc; i++)
        *word++ = argv[i];
    return to;
}

/* In the child: its standard output is free for the figures if these are to come there. */
static void become_run(const struct work *w)
{
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (w->place.command.in && !freopen(w->place.command.in, "r", stdin))
        _exit(CLI_EXIT_INPUT);
    if (w->parts.json && !strcmp(w->parts.json, "-"))
        dup2(STDERR_FILENO, STDOUT_FILENO);
    execv(w->argv[0], w->argv);
    _exit(failed(xasprintf("%s cannot be run: %m", w->argv[0]), CLI_EXIT_INPUT));
}

/* Returns the exit status. A signal from the terminal is for the run to answer; if it ends the run, it ends
 * this process, too, when all is tidied up (cli_sensitivity). */
static int run_itself(struct work *w)
{
    int how = 0;
    pid_t pid = fork();
    if (pid < 0)
        return failed(xasprintf("the run cannot be started: %m"), CLI_EXIT_INPUT);
    if (!pid)
        become_run(w);
    void (*interrupt)(int) = signal(SIGINT, SIG_IGN);
    while (waitpid(pid, &how, 0) < 0 && errno == EINTR)
        ;
    signal(SIGINT, interrupt);
    w->killed_by = WIFSIGNALED(how) ? WTERMSIG(how) : 0;
    return WIFEXITED(how) ? WEXITSTATUS(how) : 128 + WTERMSIG(how);
}

/* --- the re-runs ---------------------------------------------------------------------------------------- */

/* Writes the figures where the user wants them. */
static int write_figures(const struct work *w)
{
    json_t *figures = w->parts.json ? json_load_file(w->json, 0, NULL) : NULL;
    if (!figures)
        return 0;
    if (w->sensitivity->list && w->sensitivity->runs.list[0].done)
        json_set(figures, "sensitivity", sensitivity_json(w->sensitivity));
    char *error = json_file_write(figures, w->parts.json);
    return error ? failed(error, CLI_EXIT_OUTPUT) : 0;
}

static const char *name_of(const struct work *w)
{
    return basename(w->parts.what.host ? w->parts.what.host : w->parts.what.program[0]);
}

/* Returns the exit status. */
static int run_all(struct work *w)
{
    struct timespec begun;
    vtime end;
    char *error = NULL;
    clock_gettime(CLOCK_REALTIME_COARSE, &begun); /* the files' clock */
    if (w->parts.cfs && !access(w->parts.cfs, F_OK) &&
        !rerun_copy_cfs(&w->place, &w->sensitivity->runs, &error))
        return failed(error, CLI_EXIT_INPUT);
    int status = run_itself(w);
    w->place.apart = &begun;
    if (status && status != EXIT_FINDINGS) {
        if (!w->killed_by)
            cli_say_warning("run", "--sensitivity needs a run that ends well");
    } else if (!rerun_time(w->json, &end, &error) ||
               !sensitivity_run(w->sensitivity, &w->place, end, &error)) {
        int stopped = w->sensitivity->runs.stopped;
        status = failed(error, stopped ? 128 + stopped : CLI_EXIT_INPUT);
    } else {
        sensitivity_print(w->sensitivity, name_of(w), w->again.cfg->name, stderr);
    }
    int written = write_figures(w);
    return written ? written : status;
}

/* --- what they need ------------------------------------------------------------------------------------- */

static bool keep_input(struct work *w, char **error)
{
    char *text = NULL;
    size_t bytes = 0;
    if (standard_input_read(&text, &bytes, error) && bytes) {
        w->input = xasprintf("%s/input", w->place.scratch);
        atomic_file_write(w->input, text, bytes, error);
        w->place.command.in = w->input;
    }
    free(text);
    return !*error;
}

/* Names that lead out of the current folder are found from another one only by their whole paths. */
static const char *anywhere(const char *name, char path[PATH_MAX])
{
    return name && !strncmp(name, "..", 2) && realpath(name, path) ? path : name;
}

static bool prepare(struct work *w, const char *scratch, char **error)
{
    w->json = xasprintf("%s/run.json", scratch);
    if (!run_again_of(&w->parts, w->folder, &w->places, &w->again, error))
        return false;
    words_add_option(&w->again.options, "--host-files", xstrdup(w->folder)); /* they work in other folders */
    w->again.command.options = w->again.options;
    FILE *progress = isatty(STDERR_FILENO) ? stderr : NULL;
    const struct cli_program *what = &w->parts.what;
    w->own_folders = own_folder_place(scratch, w->folder, what->program + !!what->program_count);
    if (!w->own_folders)
        *error = xasprintf("%s: folders for runs cannot be made: %m", scratch);
    w->place = (struct rerun_place){w->again.command, w->own_folders, cli_jobs(0), progress, NULL};
    return w->own_folders && (w->sensitivity = sensitivity_new(w->again.cfg, error)) && keep_input(w, error);
}

static int do_work(struct work *w, int argc, char **argv)
{
    char *error = NULL, paths[2][PATH_MAX];
    struct cli_program *what = &w->parts.what;
    struct scratch scratch = folder_scratch("touchstone-sensitivity", &error);
    int status;
    w->folder = xchecked(getcwd(NULL, 0));
    what->host = anywhere(what->host, paths[0]);
    if (what->program_count)
        what->program[0] = (char *)(uintptr_t)anywhere(what->program[0], paths[1]);
    if (!scratch.path || !prepare(w, scratch.path, &error)) {
        status = failed(error, CLI_EXIT_INPUT);
    } else {
        w->argv = run_argv(w, argc, argv);
        status = run_all(w);
    }
    scratch_remove(&scratch);
    return status;
}

int cli_sensitivity(int argc, char **argv)
{
    struct work w = {0};
    cli_run_read(argc, argv, &w.parts);
    if (!cli_find_installation(&w.places, "run"))
        return CLI_EXIT_INPUT;
    int status = do_work(&w, argc, argv);
    if (w.sensitivity)
        sensitivity_free(w.sensitivity);
    run_again_free(&w.again);
    cli_program_free(&w.parts.what);
    free(w.parts.host_files);
    free(w.folder);
    free(w.json);
    free(w.own_folders);
    free(w.input);
    free(w.argv);
    if (w.killed_by)
        raise(w.killed_by);
    return status;
}
