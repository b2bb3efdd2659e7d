/* trial.c - see trial.h. */
#include "trial.h"
#include "trace_text.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

const char *const RESULT_NAMES[RESULTS] = {"messages", "output", "errors",  "figures",
                                           "profile",  "trace",  "schedule"};

enum { MOST_ARGUMENTS = 64, PATIENCE_S = 1200 }; /* only what hangs takes so long, on a busy computer, too */

/* --- arguments --- */

struct arguments {
    char *list[MOST_ARGUMENTS];
    int count;
};

__attribute__((format(printf, 2, 3))) static void add(struct arguments *a, const char *fmt, ...)
{
    va_list ap;
    va_start(ap, fmt);
    if (a->count == MOST_ARGUMENTS - 1 || vasprintf(&a->list[a->count++], fmt, ap) < 0)
        abort();
    va_end(ap);
    a->list[a->count] = NULL;
}

static void free_arguments(struct arguments *a)
{
    for (int i = 0; i < a->count; i++)
        free(a->list[i]);
}

static void add_words(struct arguments *a, const char *words)
{
    for (const char *w = words + strspn(words, " "); *w; w += strspn(w, " ")) {
        int length = (int)strcspn(w, " ");
        add(a, "%.*s", length, w);
        w += length;
    }
}

/* The arguments that determine the results: from the machine to the program. */
static void add_program(struct arguments *a, const struct program *p, const char *way, const char *folder)
{
    add(a, "-m");
    add(a, "%s", p->machine);
    if (!p->cube) {
        add(a, "-n");
        add(a, "%u", p->nodes);
    }
    add(a, "--max-virtual-time");
    add(a, "%.6f", p->most_virtual_s);
    for (int i = 0; i < p->set_count; i++) {
        add(a, "--set");
        add(a, "%s", p->set[i]);
    }
    if (*p->timing && strcmp(way, TRIAL_REPLAYED) != 0) {
        add(a, "--timing");
        add(a, "%s", p->timing);
    }
    if (p->host) {
        add(a, "--host");
        add(a, "%splayer-host", folder);
    }
    add(a, "%splayer%s", folder,
        p->flushes   ? "-flushes"
        : p->profile ? "-profile"
        : p->mpi     ? "-mpi"
        : p->fortran ? "-fortran"
                     : "");
    if (p->host)
        return;
    add(a, "one,two,,three");
    add(a, "of,node,program");
}

static bool is_traced(const struct program *p, const char *way)
{
    return p->traced && strcmp(way, TRIAL_UNTRACED) != 0;
}

static bool is_recorded(const struct program *p, const char *way)
{
    return p->recorded && strcmp(way, TRIAL_UNTRACED) != 0;
}

static struct arguments command(const struct place *place, const struct program *p, const char *way)
{
    struct arguments a = {0};
    char folder[PATH_MAX];
    add(&a, "%s/touchstone", place->build);
    add(&a, "run");
    add(&a, "--max-wall-time");
    add(&a, "%d", PATIENCE_S / 2);
    add(&a, "--history");
    add(&a, "%s/%s", place->folder, RESULT_NAMES[HISTORY]);
    add(&a, "--json");
    add(&a, "%s/%s", place->folder, RESULT_NAMES[FIGURES]);
    if (p->profile) {
        add(&a, "--profile");
        add(&a, "%s/%s", place->folder, RESULT_NAMES[PROFILE]);
    }
    if (is_traced(p, way)) {
        add(&a, "--trace");
        add(&a, "%s/%s", place->folder, RESULT_NAMES[TRACE]);
    }
    if (is_recorded(p, way)) {
        add(&a, "--record");
        add(&a, "%s/%s", place->folder, RESULT_NAMES[SCHEDULE]);
    }
    if (strcmp(way, TRIAL_REPLAYED) == 0) {
        add(&a, "--replay");
        add(&a, "%s/replayed", place->folder);
    } else {
        add_words(&a, way);
    }
    snprintf(folder, sizeof folder, "%s/tests/prove/", place->build);
    add_program(&a, p, way, folder);
    return a;
}

void trial_print_command(const struct program *p, const char *way, FILE *f)
{
    struct arguments a = {0};
    add(&a, "touchstone");
    add(&a, "run");
    add_words(&a, way);
    add_program(&a, p, way, "");
    for (int i = 0; i < a.count; i++)
        fprintf(f, "%s%s", i ? " " : "", a.list[i]);
    fputc('\n', f);
    free_arguments(&a);
}

/* The environment of a run: the scripts, words to change, and the computer's paths; nothing else of the
 * prover's. */
static void environment(const struct program *p, char **all)
{
    static const char *const KEPT[] = {"PATH",         "HOME",        "TMPDIR", "TOUCHSTONE_HOME",
                                       "ASAN_OPTIONS", "TSAN_OPTIONS"};
    int count = 0;
    for (size_t i = 0; i < sizeof KEPT / sizeof *KEPT; i++) {
        const char *value = getenv(KEPT[i]);
        if (value && asprintf(&all[count++], "%s=%s", KEPT[i], value) < 0)
            abort();
    }
    for (int i = 0; i < SCRIPTS; i++)
        if (p->script[i].count)
            all[count++] = program_script(p, i);
    all[count++] = strdup("PROVE_WORDS=" TRIAL_WORDS);
    all[count] = NULL;
}

/* --- running --- */

static void path_of(const struct place *place, int result, char *path)
{
    snprintf(path, PATH_MAX, "%s/%s", place->folder, RESULT_NAMES[result]);
}

/* Waits for the run to end, for a limited time. */
static int status_of(pid_t child)
{
    int status;
    for (int ms = 0; ms < PATIENCE_S * 1000; ms++) {
        pid_t r = waitpid(child, &status, WNOHANG);
        if (r == child)
            return status;
        if (r < 0)
            return -1;
        nanosleep(&(struct timespec){0, ms < 100 ? 500000 : 5000000}, NULL);
    }
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
    return -1;
}

static int run(const struct place *place, const struct program *p, const char *way)
{
    struct arguments a = command(place, p, way);
    char *all[SCRIPTS + 8], out[PATH_MAX], err[PATH_MAX];
    posix_spawn_file_actions_t files;
    pid_t child;
    environment(p, all);
    path_of(place, OUTPUT, out);
    path_of(place, ERRORS, err);
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, 1, out, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_addopen(&files, 2, err, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    int error = posix_spawn(&child, a.list[0], &files, NULL, a.list, all);
    posix_spawn_file_actions_destroy(&files);
    free_arguments(&a);
    for (char **e = all; *e; e++)
        free(*e);
    if (error) {
        fprintf(stderr, "prove: %s/touchstone: %s\n", place->build, strerror(error));
        exit(2);
    }
    return status_of(child);
}

/* (Comments of schedules tell with which seed delays were drawn.) */
static bool is_another_each_time(const char *line)
{
    return strncmp(line, "# --timing", 10) == 0 || strncmp(line, "wall time", 9) == 0 ||
           strstr(line, "\"wall_time") != NULL;
}

static char *read_result(const char *path)
{
    char *text, *line = NULL;
    size_t size, room = 0;
    FILE *from = fopen(path, "r"), *to = open_memstream(&text, &size);
    while (from && getline(&line, &room, from) >= 0)
        if (!is_another_each_time(line))
            fputs(line, to);
    free(line);
    fclose(to);
    if (from)
        fclose(from);
    return text;
}

/* Keeps a schedule for TRIAL_REPLAYED. */
static void keep_schedule(const struct place *place, const char *text)
{
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/replayed", place->folder);
    FILE *f = fopen(path, "w");
    if (!f || fputs(text, f) < 0 || fclose(f))
        abort();
}

struct trial trial_run(const struct place *place, const struct program *p, const char *way)
{
    struct trial t = {.traced = is_traced(p, way), .recorded = is_recorded(p, way)};
    char path[PATH_MAX];
    for (int i = 0; i < RESULTS; i++) {
        path_of(place, i, path);
        unlink(path);
    }
    t.status = run(place, p, way);
    for (int i = 0; i < RESULTS; i++) {
        path_of(place, i, path);
        t.text[i] = i == TRACE ? trace_text(path) : read_result(path);
    }
    if (t.recorded && strcmp(way, TRIAL_REFERENCE) == 0)
        keep_schedule(place, t.text[SCHEDULE]);
    return t;
}

void trial_free(struct trial *t)
{
    for (int i = 0; i < RESULTS; i++)
        free(t->text[i]);
}

int trial_differs(const struct trial *a, const struct trial *b)
{
    for (int i = 0; i < RESULTS; i++)
        if (strcmp(a->text[i], b->text[i]) != 0 && (i != TRACE || (a->traced && b->traced)) &&
            (i != SCHEDULE || (a->recorded && b->recorded)))
            return i;
    return a->status == b->status ? -1 : RESULTS;
}

static const char *next_line(const char *line)
{
    const char *end = strchr(line, '\n');
    return end ? end + 1 : line + strlen(line);
}

static void print_lines(const char *how, const char *text, int most, FILE *f)
{
    for (; *text && most-- > 0; text = next_line(text))
        fprintf(f, "  %s %.*s\n", how, (int)strcspn(text, "\n"), text);
}

void trial_print_difference(const char *name, const char *a, const char *b, FILE *f)
{
    enum { LINES = 6 };
    int line = 1;
    const char *before = a;
    if (strcmp(a, b) == 0)
        return;
    while (*a && *b && next_line(a) - a == next_line(b) - b && !strncmp(a, b, (size_t)(next_line(a) - a)))
        before = a, a = next_line(a), b = next_line(b), line++;
    fprintf(f, "%s, from line %d:\n", name, line);
    if (before != a)
        print_lines(" ", before, 1, f);
    print_lines("reference", a, LINES, f);
    print_lines("fast     ", b, LINES, f);
}
