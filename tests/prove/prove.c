/* prove.c - `make prove`: searches for a program on which the fast engine's results differ from those of the
 * reference engine, which defines what is right.
 *
 *   prove --build DIR [--seed N] [--count N | --seconds S] [--jobs J] [--load L] [--all]
 *   prove --print --seed N                                                          the program of a seed
 *
 * The reference runs random programs (program.h); then the fast engine runs each with one worker and several,
 * with workers scheduled at random, and with slices, while L computing processes compete for the processors.
 * The first failing program is made as small as possible, and printed as a C program, with the command that
 * runs it and the first difference. Exit status: 0 no difference, 1 a difference, 2 the programs could not be
 * run. */
#include <getopt.h>
#include <inttypes.h>
#include <math.h>
#include <limits.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include "shrink.h"

struct options {
    const char *build;
    uint64_t seed, count; /* count 0: as many as there is time for */
    double seconds;
    unsigned jobs, load;
    bool keep_going, print;
};

/* Shared by all provers, which are processes. */
struct shared {
    atomic_uint_fast64_t next, done, messages;
    atomic_bool found;
};

enum { WAYS = 6, MOST_WAY = 80 };

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* One worker, or several; their order and the slices differ with the program. (--isolate takes the computer
 * hours for ranks of MPI that poll until the limit of virtual time.) */
static void choose_ways(const struct program *p, char way[WAYS][MOST_WAY])
{
    uint64_t r = p->seed ^ UINT64_C(0x5eed);
    unsigned shuffle = 1 + (unsigned)random_below(&r, 1000);
    double slice = 1e-7 * (double)(1 + random_below(&r, 3000));
    strcpy(way[0], TRIAL_UNTRACED);
    strcpy(way[1], p->recorded ? TRIAL_REPLAYED : "-w 2");
    strcpy(way[2], random_chance(&r, 0.5) ? "-w 4" : "-w 8");
    snprintf(way[3], MOST_WAY, "-w 3 --shuffle %u", shuffle);
    if (p->mpi || random_chance(&r, 0.5))
        snprintf(way[4], MOST_WAY, "-w 1 --slice %g", slice);
    else
        strcpy(way[4], "-w 1 --isolate");
    snprintf(way[5], MOST_WAY, "-w 2 --shuffle %u --slice %g", shuffle + 1, slice);
}

/* Prints the program as C, and the command that runs it. */
static void print_program(const struct program *p, const char *way, const char *build)
{
    char parts[PATH_MAX];
    snprintf(parts, sizeof parts, "%s/tests/prove/parts.h", build);
    program_print(p, parts, stdout);
    printf("\nIts scripts for %s/tests/prove/player:\n", build);
    for (int i = 0; i < SCRIPTS; i++)
        if (p->script[i].count) {
            char *script = program_script(p, i);
            printf("export %.*s='%s'\n", (int)strcspn(script, "="), script,
                   script + strcspn(script, "=") + 1);
            free(script);
        }
    printf("export PROVE_WORDS='%s'\n", TRIAL_WORDS);
    trial_print_command(p, TRIAL_REFERENCE, stdout);
    trial_print_command(p, way, stdout);
}

static void report(const struct place *place, struct program *p, const char *way, const char *build)
{
    printf("\nprogram %" PRIu64 " differs with %s. Making it smaller, from %zu operations on %u nodes ...\n",
           p->seed, way, program_ops(p), p->nodes);
    fflush(stdout);
    shrink(place, &p, way);
    struct trial right = trial_run(place, p, TRIAL_REFERENCE), t = {0};
    for (int i = 0; i < 20; i++) {
        trial_free(&t);
        t = trial_run(place, p, way);
        if (trial_differs(&right, &t) >= 0)
            break;
    }
    printf("%zu operations on %u nodes are left:\n\n", program_ops(p), p->nodes);
    print_program(p, way, build);
    printf("\nstatus %#x by the reference, %#x with %s\n", right.status, t.status, way);
    for (int i = 0; i < RESULTS; i++)
        trial_print_difference(RESULT_NAMES[i], right.text[i], t.text[i], stdout);
    fflush(stdout);
    trial_free(&right);
    trial_free(&t);
    program_free(p);
}

static uint64_t lines(const char *text)
{
    uint64_t n = 0;
    for (; *text; text++)
        n += *text == '\n';
    return n;
}

/* Tries one program. Returns the way of running it whose results differ, or NULL. */
static const char *try(const struct place *place, const struct program *p, char way[WAYS][MOST_WAY],
                       struct shared *all)
{
    const char *wrong = NULL;
    struct trial right = trial_run(place, p, TRIAL_REFERENCE);
    atomic_fetch_add(&all->messages, lines(right.text[HISTORY]));
    if (WIFEXITED(right.status) && WEXITSTATUS(right.status) > 2) {
        fprintf(stderr, "prove: program %" PRIu64 " cannot be run: %s", p->seed, right.text[ERRORS]);
        exit(2);
    }
    if (right.status == -1 || WIFSIGNALED(right.status))
        wrong = way[0];
    for (int i = 0; i < WAYS && !wrong; i++) {
        struct trial t = trial_run(place, p, way[i]);
        if (trial_differs(&right, &t) >= 0)
            wrong = way[i];
        trial_free(&t);
    }
    trial_free(&right);
    return wrong;
}

static void prove(const struct options *o, const struct place *place, struct shared *all, double end)
{
    while ((o->keep_going || !atomic_load(&all->found)) && seconds() < end) {
        uint64_t i = atomic_fetch_add(&all->next, 1);
        if (o->count && i >= o->count)
            return;
        struct program *p = program_new(o->seed + i);
        char ways[WAYS][MOST_WAY];
        choose_ways(p, ways);
        const char *wrong = try(place, p, ways, all);
        if (wrong && o->keep_going) {
            printf("\nprogram %" PRIu64 " differs with %s: %zu operations on %u nodes of %s\n", p->seed,
                   wrong, program_ops(p), p->nodes, p->machine);
            fflush(stdout);
            atomic_store(&all->found, true);
            program_free(p);
        } else if (wrong && !atomic_exchange(&all->found, true)) {
            report(place, p, wrong, o->build);
        } else {
            program_free(p);
        }
        atomic_fetch_add(&all->done, 1);
    }
}

/* Processes that only compute, for ten seconds of every twenty. */
static pid_t begin_load(void)
{
    pid_t child = fork();
    if (child)
        return child;
    for (volatile uint64_t x = 0;; x++)
        if (x % (1 << 20) == 0 && (uint64_t)seconds() / 10 % 2)
            sleep(1);
}

static pid_t begin_prover(const struct options *o, struct shared *all, double end, char *folder)
{
    pid_t child = fork();
    if (child)
        return child;
    prove(o, &(struct place){o->build, folder}, all, end);
    exit(0);
}

static void show_progress(const struct shared *all, double begin, bool last)
{
    if (isatty(1) || last)
        printf("%s%" PRIu64 " programs, %" PRIu64 " messages, %.0f s%s", isatty(1) ? "\r" : "",
               (uint64_t)all->done, (uint64_t)all->messages, seconds() - begin, last ? "\n" : " ");
    fflush(stdout);
}

static int run_provers(const struct options *o, struct shared *all)
{
    double begin = seconds(), end = o->seconds > 0 ? begin + o->seconds : INFINITY;
    pid_t load[64], prover[64];
    char folder[64][64];
    for (unsigned i = 0; i < o->load; i++)
        load[i] = begin_load();
    for (unsigned i = 0; i < o->jobs; i++) {
        strcpy(folder[i], "/tmp/touchstone-prove-XXXXXX");
        if (!mkdtemp(folder[i]))
            return 2;
        prover[i] = begin_prover(o, all, end, folder[i]);
    }
    int status = 0;
    for (unsigned left = o->jobs; left > 0;) {
        int s;
        pid_t child = waitpid(-1, &s, WNOHANG);
        show_progress(all, begin, false);
        if (child == 0)
            sleep(1);
        for (unsigned i = 0; child > 0 && i < o->jobs; i++) {
            left -= prover[i] == child, status |= prover[i] == child && s ? 2 : 0;
            if (prover[i] == child && WIFSIGNALED(s))
                fprintf(stderr, "prove: a process that tries programs ended: %s\n", strsignal(WTERMSIG(s)));
        }
    }
    for (unsigned i = 0; i < o->load; i++)
        kill(load[i], SIGKILL);
    for (unsigned i = 0; i < o->jobs; i++) {
        char command[100];
        snprintf(command, sizeof command, "rm -rf %s", folder[i]);
        status |= system(command) ? 2 : 0;
    }
    show_progress(all, begin, true);
    return status ? status : atomic_load(&all->found);
}

static int usage(void)
{
    fprintf(stderr,
            "usage: prove --build DIR [--seed N] [--count N | --seconds S] [--jobs J] [--load L] [--all]\n"
            "       prove --print --seed N\n");
    return 2;
}

int main(int argc, char **argv)
{
    static const struct option LONG[] = {
        {"build", 1, NULL, 'b'},   {"seed", 1, NULL, 's'},  {"count", 1, NULL, 'c'},
        {"seconds", 1, NULL, 't'}, {"jobs", 1, NULL, 'j'},  {"load", 1, NULL, 'l'},
        {"all", 0, NULL, 'a'},     {"print", 0, NULL, 'p'}, {0}};
    struct options o = {
        .build = "build", .seed = (uint64_t)time(NULL), .jobs = (unsigned)sysconf(_SC_NPROCESSORS_ONLN)};
    for (int c; (c = getopt_long(argc, argv, "", LONG, NULL)) != -1;)
        switch (c) {
        case 'b':
            o.build = optarg;
            break;
        case 's':
            o.seed = strtoull(optarg, NULL, 10);
            break;
        case 'c':
            o.count = strtoull(optarg, NULL, 10);
            break;
        case 't':
            o.seconds = strtod(optarg, NULL);
            break;
        case 'j':
            o.jobs = (unsigned)strtoul(optarg, NULL, 10);
            break;
        case 'l':
            o.load = (unsigned)strtoul(optarg, NULL, 10);
            break;
        case 'a':
            o.keep_going = true;
            break;
        case 'p':
            o.print = true;
            break;
        default:
            return usage();
        }
    if (o.print) {
        struct program *p = program_new(o.seed);
        print_program(p, "-w 1", o.build);
        program_free(p);
        return 0;
    }
    if (optind < argc || (!o.count && o.seconds <= 0) || !o.jobs || o.jobs > 64 || o.load > 64)
        return usage();
    struct shared *all = mmap(NULL, sizeof *all, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (all == MAP_FAILED)
        return 2;
    printf("programs from seed %" PRIu64 " on, %u at a time, %u busy processes beside\n", o.seed, o.jobs,
           o.load);
    fflush(stdout);
    return run_provers(&o, all);
}
