/* machine.c - see machine.h. */
#include "machine/machine.h"
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "cfs/cfs.h"
#include "machine/crash.h"
#include "machine/endpoints.h"
#include "lp/clock.h"
#include "machine/cube.h"
#include "lp/engine.h"
#include "guest/image.h"
#include "guest/trace.h"
#include "machine/assemble.h"
#include "node/self.h"
#include "os/end.h"
#include "os/first_failure.h"
#include "os/gate.h"

static double wall_clock(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* --- putting together --- */

/* Those there are room for. */
static uint32_t nodes_of(const struct machine_options *o)
{
    const struct cfg_machine *c = o->cfg;
    if (o->nodes)
        return o->nodes;
    return c->topology == CFG_HYPERCUBE ? UINT32_C(1) << c->dimension : c->rows * c->columns;
}

static bool has_host(const struct machine *m, char **error)
{
    const struct cfg_machine *c = m->options.cfg;
    if (!m->options.host || c->host.clock_hz)
        return true;
    if (asprintf(
            error,
            "%s has no host (its machine file, %s, has no group host): run the host program on an iPSC/860, "
            "-m ipsc860",
            c->name, c->path) < 0)
        abort();
    return false;
}

static bool make_shape(struct machine *m, char **error)
{
    const struct cfg_machine *c = m->options.cfg;
    uint32_t n = m->sys.count;
    bool cube = c->topology == CFG_HYPERCUBE;
    if (cube ? topo_hypercube(&m->sys.topo, n, c->dimension)
             : topo_mesh(&m->sys.topo, n, c->rows, c->columns)) {
        topo_add_services(&m->sys.topo, cfs_services(c));
        if (m->options.host)
            topo_add_host(&m->sys.topo);
        return true;
    }
    int r = cube ? asprintf(error, "%s has no %u nodes: it is a hypercube of at most %u", c->name, n,
                            1u << c->dimension)
                 : asprintf(error, "%s has no rectangle of %u nodes: it is a mesh of %u x %u", c->name, n,
                            c->rows, c->columns);
    if (r < 0)
        abort();
    return false;
}

static bool make_file_system(struct machine *m, char **error)
{
    struct node_system *s = &m->sys;
    if (!s->cfg->cfs.io_nodes && !m->options.cfs_dir)
        return true;
    if (!s->cfg->cfs.io_nodes) {
        if (asprintf(error, "--cfs %s: %s has no file system of its own", m->options.cfs_dir, s->cfg->name) <
            0)
            abort();
        return false;
    }
    s->cfs = cfs_new(s, m->options.cfs_dir, error);
    if (s->cfs)
        s->fs = cfs_fs(s->cfs);
    return s->cfs;
}

/* The host program, and nodes without programs. */
static bool make_host(struct machine *m, char **error)
{
    const struct machine_options *o = &m->options;
    struct node_system *s = &m->sys;
    cube_new(s, &(struct cube_options){.most = s->count,
                                       .given = o->nodes > 0,
                                       .program = o->program,
                                       .host = o->argv[0],
                                       .envp = o->envp});
    s->host = node_new_host(s, topo_host(&s->topo), m->image, o->argc, o->argv, o->envp, error);
    if (!s->host)
        return false;
    s->running = 1;
    lp_start(&s->host->lp, 0);
    return true;
}

static bool make_nodes(struct machine *m, char **error)
{
    struct node_system *s = &m->sys;
    m->image = node_image_open(m->options.argv[0], error);
    if (!m->image)
        return false;
    if (m->options.host)
        return make_host(m, error);
    s->flushes = node_image_uses(m->image, "flushmsg") || node_image_uses(m->image, "_flushmsg");
    s->nodes = calloc(s->count, sizeof *s->nodes);
    for (uint32_t i = 0; i < s->count; i++) {
        s->nodes[i] = node_new(s, i, m->image, m->options.argc, m->options.argv, m->options.envp, error);
        if (!s->nodes[i])
            return false;
        lp_start(&s->nodes[i]->lp, 0);
    }
    return true;
}

struct machine *machine_new(const struct machine_options *options, char **error)
{
    double begin = wall_clock();
    struct machine *m = calloc(1, sizeof *m);
    if (!m)
        abort();
    m->options = *options;
    struct node_system *s = &m->sys;
    s->cfg = options->cfg;
    s->count = s->running = nodes_of(options);
    s->schedule.max_time =
        options->max_virtual_s > 0 ? (vtime)(options->max_virtual_s * (double)VT_SECOND) : VT_NEVER;
    s->schedule.longest_slice = options->slice_s > 0 ? (vtime)(options->slice_s * (double)VT_SECOND) : 0;
    s->history = options->history;
    s->guards = NODE_GUARDS_ALL;
    s->isolate = options->isolate;
    s->out[0] = options->out, s->out[1] = options->err;
    s->schedule.q = evq_new();
    if (!has_host(m, error) || !make_shape(m, error))
        goto fail;
    struct protocol_nodes up = endpoints_calls(s);
    s->schedule.protocol = protocol_new(s->cfg, &s->topo, s->schedule.q, &up);
    if (!make_file_system(m, error) || !make_nodes(m, error))
        goto fail;
    m->start_s = wall_clock() - begin;
    return m;
fail:
    machine_free(m);
    return NULL;
}

void machine_free(struct machine *m)
{
    if (!m)
        return;
    /* Latest first: the C library finds the streams made last soonest. */
    node_delete(m->sys.host);
    for (uint32_t i = m->sys.nodes && !m->sys.cube ? m->sys.count : 0; i-- > 0;)
        node_delete(m->sys.nodes[i]);
    cube_free(m->sys.cube);
    arena_free(&m->sys.made);
    arena_free(&m->sys.made_cold);
    free(m->sys.nodes);
    cfs_free(m->sys.cfs);
    protocol_free(m->sys.schedule.protocol);
    evq_free(m->sys.schedule.q);
    mintree_free(&m->sys.schedule.polls);
    if (m->image)
        node_image_close(m->image);
    for (size_t i = 0; i < m->sys.host_file_count; i++)
        free(m->sys.host_files[i]);
    free(m->sys.host_files);
    for (size_t i = 0; i < m->sys.absent_count; i++) {
        free(m->sys.absent[i].function);
        free(m->sys.absent[i].first);
    }
    free(m->sys.absent);
    free(m->sys.failure);
    free(m->message);
    free(m);
}

/* --- running --- */

/* Signals that end a run. While it goes on they wait, and are looked at now and then: so what the nodes have
 * printed is not lost, and it can be said where each is. */
static const int ENDING[] = {SIGINT, SIGTERM, SIGHUP};
enum { ENDINGS = sizeof ENDING / sizeof *ENDING };

/* Those that are not ignored, as under nohup. */
static sigset_t ending_signals(void)
{
    sigset_t set;
    sigemptyset(&set);
    for (int i = 0; i < ENDINGS; i++) {
        struct sigaction now;
        if (sigaction(ENDING[i], NULL, &now) == 0 && now.sa_handler != SIG_IGN)
            sigaddset(&set, ENDING[i]);
    }
    return set;
}

/* The world outside: the wall clock's limit, and who wants the run to end. Neither changes a result, they
 * only end the run. */
static void look_outside(void *ctx)
{
    struct machine *m = ctx;
    sigset_t pending;
    sigpending(&pending);
    for (int i = 0; i < ENDINGS && !m->signal; i++)
        if (sigismember(&pending, ENDING[i]))
            m->signal = ENDING[i];
    if (m->signal)
        node_system_fail(&m->sys, STOP_INTERRUPTED, (struct instant){0},
                         m->signal == SIGINT ? "interrupted" : "stopped by SIG%s", sigabbrev_np(m->signal));
    if (m->options.max_wall_s > 0 && wall_clock() - m->begin > m->options.max_wall_s)
        node_system_fail(&m->sys, STOP_WALL_TIME, (struct instant){0}, "wall time limit of %g s reached",
                         m->options.max_wall_s);
}

/* At the crash's place in the order of events. */
static void show_crash(struct node *n)
{
    node_end_crashed(n);
    char *report = crash_report(n);
    node_system_fail(n->sys, STOP_FAILED, (struct instant){n->stats.ended_at, n->lp.address}, "%s", report);
    free(report);
}

static void *thread_begins(void)
{
    return crash_watch();
}

static void thread_ends(void *guard)
{
    crash_unwatch(guard);
}

static void run_events(struct machine *m)
{
    struct node_system *s = &m->sys;
    struct crash_guard *guard = crash_watch();
    crash_catch();
    s->keep_crash = crash_keep, s->crashed = show_crash, s->print_calls = trace_print_calls;
    s->schedule.look = look_outside, s->schedule.look_ctx = m;
    m->workers = engine_run(&s->schedule,
                            &(struct engine_threads){s->isolate ? 1 : m->options.workers, m->options.shuffle,
                                                     thread_begins, thread_ends, guard});
    crash_ignore();
    crash_unwatch(guard);
}

/* The source line in which the node is, NULL: unknown. One that computes may have run on before it was known
 * that the system takes time from it: at a limit of virtual time, where a report is always the same, it is
 * the line at its last look. */
static const char *line_of(const struct node *n, struct trace_lines *lines)
{
    if (n->call)
        return n->lp.state == LP_BLOCKED || n->call_since == VT_NEVER ? trace_line(lines, n) : NULL;
    if (n->sys->schedule.stop == STOP_VIRTUAL_TIME)
        return trace_line_at(lines, n, clock_last_place(&n->lp));
    return n->at_poll ? trace_line(lines, n) : NULL;
}

static void describe_waiting(FILE *f, const struct node *n, struct trace_lines *lines)
{
    fprintf(f, "\n  %s: ", n->name);
    if (n->end == NODE_NOT_LOADED)
        fprintf(f, "no program");
    else if (n->lp.state == LP_ENDED)
        fprintf(f, "ended at %.9f s", vt_seconds(n->stats.ended_at));
    else if (!n->call)
        fprintf(f, "computing");
    else if (n->call_since == VT_NEVER)
        fprintf(f, "before %s", n->call);
    else if (n->call_has_type)
        fprintf(f, "%s(%ld) since %.9f s", n->call, n->call_type, vt_seconds(n->call_since));
    else
        fprintf(f, "%s since %.9f s", n->call, vt_seconds(n->call_since));
    const char *line = n->lp.state == LP_ENDED ? NULL : line_of(n, lines);
    if (line)
        fprintf(f, " (%s)", line);
}

static char *describe(const struct machine *m, const char *what)
{
    char *text;
    size_t size;
    struct trace_lines *lines = trace_lines_new();
    FILE *f = open_memstream(&text, &size);
    fprintf(f, "%s", what);
    if (m->sys.host)
        describe_waiting(f, m->sys.host, lines);
    for (uint32_t i = 0; i < m->sys.count; i++)
        describe_waiting(f, m->sys.nodes[i], lines);
    trace_lines_free(lines);
    fclose(f);
    return text;
}

static bool exited_badly(const struct node *n)
{
    return n->end == NODE_EXITED && n->exit_code != 0;
}

/* The first node that called exit or abort with an error; NULL none. */
static struct node *bad_exit(const struct machine *m)
{
    for (uint32_t i = 0; i < m->sys.count; i++)
        if (exited_badly(m->sys.nodes[i]))
            return m->sys.nodes[i];
    return m->sys.host && exited_badly(m->sys.host) ? m->sys.host : NULL;
}

static void judge(struct machine *m)
{
    struct node_system *s = &m->sys;
    const struct node *bad = bad_exit(m);
    enum stop stop = s->schedule.stop;
    bool limit = stop == STOP_VIRTUAL_TIME || stop == STOP_WALL_TIME || stop == STOP_INTERRUPTED;
    m->outcome = MACHINE_ENDED;
    if (s->failure) {
        m->outcome = MACHINE_FAILED;
        m->message = limit ? describe(m, s->failure) : strdup(s->failure);
    } else if (bad) {
        m->outcome = MACHINE_FAILED;
        char *first;
        if (asprintf(&first, "%s ended at %.9f s with exit(%d)", bad->name, vt_seconds(bad->stats.ended_at),
                     bad->exit_code) < 0)
            abort();
        m->message = s->running ? describe(m, first) : strdup(first);
        free(first);
    } else if (s->running && s->host && s->host->lp.state == LP_ENDED) {
        m->message = describe(m, "the host program has ended; what still waits on its nodes is killed");
    } else if (s->running && stop != STOP_KILLED) {
        m->outcome = MACHINE_DEADLOCK;
        m->message = describe(m, "deadlock: every program waits, and no message is under way");
    }
}

uint32_t machine_nodes(const struct machine *m)
{
    return m->sys.cube ? cube_most(m->sys.cube) : m->sys.count;
}

static bool stops_at_a_time(const struct schedule *s)
{
    return s->stop == STOP_FAILED || s->stop == STOP_VIRTUAL_TIME;
}

/* What comes before has happened. */
static struct instant end_of(const struct schedule *s)
{
    return stops_at_a_time(s) ? s->stop_at : s->stop ? s->present : (struct instant){VT_NEVER, 0};
}

static void note_end(struct machine *m, struct node *n)
{
    const struct schedule *s = &m->sys.schedule;
    node_settle(n, end_of(s), stops_at_a_time(s));
    m->end = vt_max(m->end, n->stats.ended_at);
}

void machine_run(struct machine *m)
{
    m->begin = wall_clock();
    sigset_t ending = ending_signals(), before;
    sigprocmask(SIG_BLOCK, &ending, &before);
    run_events(m);
    for (const struct timespec now = {0}; m->signal && sigtimedwait(&ending, NULL, &now) > 0;)
        ;
    sigprocmask(SIG_SETMASK, &before, NULL);
    for (uint32_t i = 0; i < machine_nodes(m); i++)
        note_end(m, m->sys.nodes[i]);
    if (m->sys.host)
        note_end(m, m->sys.host);
    judge(m);
    m->wall_s = wall_clock() - m->begin;
}
