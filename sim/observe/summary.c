/* summary.c - see summary.h. */
#include "observe/summary.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "cfs/cfs.h"
#include "files/json_set.h"
#include "files/virtual_time.h"
#include "kernel/xalloc.h"
#include "lp/clock.h"
#include "machine/standstill.h"
#include "observe/json_file.h"
#include "observe/race_json.h"
#include "observe/race_print.h"
#include "node/self.h"
#include "nx_api/contract/spread.h"
#include "os/memory.h"

/* The time that the program itself has computed. */
static vtime busy(const struct node *n)
{
    return clock_of_units(&n->lp, n->lp.clock.units);
}

/* --- for people --- */

static void print_spread(FILE *f, const char *what, const struct spread *s)
{
    fprintf(f, "  %s %s", what, duration_text(s->sum / s->count).text);
    struct time_text least = duration_text(s->least), most = duration_text(s->most);
    if (strcmp(least.text, most.text))
        fprintf(f, " (%s to %s)", least.text, most.text);
}

static void print_host(const struct machine *m, FILE *f)
{
    const struct node *n = m->sys.host;
    if (n)
        fprintf(f, "host           busy %s  idle %s  system %s\n", duration_text(vt_seconds(busy(n))).text,
                duration_text(vt_seconds(n->stats.idle)).text,
                duration_text(vt_seconds(n->times.system)).text);
}

static void print_class(const struct machine *m, FILE *f, const char *name, bool armed)
{
    struct spread b = {0}, i = {0}, s = {0};
    uint32_t loaded = 0;
    for (uint32_t k = 0; k < machine_nodes(m); k++) {
        const struct node *n = m->sys.nodes[k];
        loaded += n->end.how != NODE_NOT_LOADED;
        if (n->handlers.armed != armed || n->end.how == NODE_NOT_LOADED)
            continue;
        spread_add(&b, vt_seconds(busy(n)));
        spread_add(&i, vt_seconds(n->stats.idle));
        spread_add(&s, vt_seconds(n->times.system));
    }
    if (b.count == 0)
        return;
    fprintf(f, "%-14s %u %s:", b.count == loaded ? "nodes" : name, b.count, b.count == 1 ? "node" : "nodes");
    print_spread(f, "busy", &b);
    print_spread(f, "idle", &i);
    print_spread(f, "system", &s);
    fputc('\n', f);
}

static void print_handlers(const struct machine *m, FILE *f)
{
    uint64_t handlers = 0;
    vtime latest = 0;
    const struct node *most = m->sys.nodes[0];
    for (uint32_t k = 0; k < machine_nodes(m); k++) {
        const struct node *n = m->sys.nodes[k];
        handlers += n->stats.handlers;
        latest = vt_max(latest, n->stats.latest);
        most = n->stats.stood > most->stats.stood ? n : most;
    }
    if (!handlers)
        return;
    fprintf(f, "interrupts     %" PRIu64 " handlers run, the latest %s after it was due", handlers,
            duration_text(vt_seconds(latest)).text);
    if (most->stats.stood)
        fprintf(f, "; the program of %s stood still for %s meanwhile", most->cold->name,
                duration_text(vt_seconds(most->stats.stood)).text);
    fputc('\n', f);
}

/* Lines only if some node came no further. A limit's report has told of them already. */
static void print_livelocks(const struct machine *m, FILE *f)
{
    enum stop stop = m->sys.schedule.stop;
    if (stop == STOP_VIRTUAL_TIME || stop == STOP_WALL_TIME || stop == STOP_INTERRUPTED)
        return;
    char *text;
    size_t size;
    FILE *lines_of = xchecked(open_memstream(&text, &size));
    struct backtrace_lines *lines = backtrace_lines_new();
    standstill_print(lines_of, &m->sys, lines, "\n               ");
    backtrace_lines_free(lines);
    fclose(lines_of);
    if (size)
        fprintf(f, "livelock       %s\n", text + strspn(text, "\n "));
    free(text);
}

static void print_files(const struct machine *m, FILE *f)
{
    struct cfs_stats s = m->sys.cfs ? cfs_stats(m->sys.cfs) : (struct cfs_stats){0};
    if (s.directory + s.reads + s.writes == 0)
        return;
    fprintf(f,
            "files          %" PRIu64 " bytes read in %" PRIu64 " pieces (%" PRIu64 " cached), %" PRIu64
            " written in %" PRIu64 "; %" PRIu64 " directory requests\n",
            s.bytes_read, s.reads, s.hits, s.bytes_written, s.writes, s.directory);
    fprintf(f, "disks          %" PRIu64 " accesses of %.1f blocks, %" PRIu64 " seeks; the busiest for %s\n",
            s.disk_accesses, s.disk_accesses ? (double)s.disk_rows / (double)s.disk_accesses : 0.0,
            s.disk_seeks, duration_text(vt_seconds(s.disk_busy)).text);
}

/* Host times and counts of tasks, which differ from run to run. */
static void print_threads(const struct workers_stats *s, FILE *f)
{
    fprintf(f,
            "threads        workers ran %" PRIu64 " tasks in %s; the coordinator ran %" PRIu64
            " in %s and waited for %s\n",
            s->away, duration_text(s->away_s).text, s->helped, duration_text(s->helped_s).text,
            duration_text(s->waited_s).text);
}

/* A line only if some memory of the nodes has no guard. */
static void print_guards(enum node_guards guards, FILE *f)
{
    static const char *const LEFT[] = {"nothing: one that overruns its stack, data or heap is not stopped",
                                       "their stacks: one that overruns its data or heap is not stopped"};
    if (guards < NODE_GUARDS_ALL)
        fprintf(f, "guards         of that many nodes this computer can guard only %s (vm.max_map_count)\n",
                LEFT[guards]);
}

/* The functions called that nodes do not have. */
static void print_absent(const struct node_system *s, FILE *f)
{
    for (size_t i = 0; i < s->absent_count; i++)
        fprintf(f, "%s%s failed with ENOSYS, as nodes do not have it: %" PRIu64 " %s, the first on %s\n",
                i == 0 ? "not there      " : "               ", s->absent[i].function, s->absent[i].calls,
                s->absent[i].calls == 1 ? "call" : "calls", s->absent[i].first);
}

void summary_print(const struct machine *m, const struct race_reports *races, bool verbose, FILE *f)
{
    size_t peak = 0;
    uint32_t where = 0;
    for (uint32_t k = 0; k < machine_nodes(m); k++)
        if (m->sys.nodes[k]->stats.memory_peak > peak)
            peak = m->sys.nodes[k]->stats.memory_peak, where = k;
    fprintf(f, "virtual time   %s on %u %s of %s\n", virtual_time_moment(m->end).text, machine_nodes(m),
            machine_nodes(m) == 1 ? "node" : "nodes", m->sys.cfg->name);
    fprintf(f, "wall time      %s, and %s to start\n", duration_text(m->wall_s).text,
            duration_text(m->start_s).text);
    if (verbose)
        print_threads(&m->workers, f);
    fprintf(f, "messages       %" PRIu64 ", %" PRIu64 " bytes; %" PRIu64 " waited for a channel, %s in all\n",
            m->sys.messages, m->sys.bytes, channel_waits(protocol_channels(m->sys.schedule.protocol)),
            duration_text(vt_seconds(channel_waited(protocol_channels(m->sys.schedule.protocol)))).text);
    print_host(m, f);
    print_class(m, f, "with handlers", true);
    print_class(m, f, "others", false);
    print_handlers(m, f);
    print_livelocks(m, f);
    print_files(m, f);
    if (machine_nodes(m)) {
        size_t limit = node_memory_limit(m->sys.nodes[0]);
        fprintf(f, "memory         %.2f MB at most (node %u), of %.2f MB for programs%s\n",
                (double)peak / 1048576, where, (double)limit / 1048576,
                peak > limit ? "; short messages that nobody received took the rest: they always find room"
                             : "");
    }
    print_absent(&m->sys, f);
    print_guards(m->sys.guards, f);
    race_print_count(races, f);
    fprintf(f, "digest         %016" PRIx64 "\n", m->sys.digest);
}

/* --- for programs --- */

/* The functions called that nodes do not have. */
static json_t *absent_json(const struct node_system *s)
{
    json_t *list = json_array();
    for (size_t i = 0; i < s->absent_count; i++)
        json_append(list, json_pack("{s:s, s:I, s:s}", "function", s->absent[i].function, "calls",
                                    (json_int_t)s->absent[i].calls, "first", s->absent[i].first));
    return list;
}

/* The parts of idle_s: an object for each call and type of message waited for. */
static json_t *waits_json(const struct node *n)
{
    json_t *list = json_array();
    for (size_t i = 0; i < n->stats.waits.count; i++) {
        const struct node_wait *w = &n->stats.waits.list[i];
        json_t *j = json_pack("{s:s, s:f, s:I}", "call", w->call, "idle_s", vt_seconds(w->idle), "waits",
                              (json_int_t)w->waits);
        if (w->has_type)
            json_set(j, "type", json_integer(w->type));
        json_append(list, j);
    }
    return list;
}

/* What the node did instead of coming further; NULL: nothing is to be told. */
static json_t *livelock_json(const struct node *n, struct backtrace_lines *lines)
{
    struct standstill s;
    if (!standstill_of(n, lines, &s))
        return NULL;
    json_t *j = json_pack("{s:s, s:I, s:f, s:f, s:f, s:b}", "kind", s.poll ? "polls" : "handlers", "count",
                          (json_int_t)s.count, "since_s", vt_seconds(s.since), "until_s", vt_seconds(s.until),
                          "share", s.share, "goes_on", s.goes_on);
    json_set(j, "call", json_text(s.poll ? s.poll->call : s.handler->sends ? "hsend" : "hrecv"));
    if (s.poll ? s.poll->asks : !s.handler->sends)
        json_set(j, "type", json_integer(s.poll ? s.poll->select.type : s.handler->type));
    if (s.line)
        json_set(j, "line", json_text(s.line));
    return j;
}

/* busy_s, idle_s, system_s and away_s (without a program) add up to ended_s; the tasks add up to system_s and
 * beside_s. */
static json_t *node_json(const struct node *n, struct backtrace_lines *lines)
{
    double tasks[NODE_TASKS];
    for (int i = 0; i < NODE_TASKS; i++)
        tasks[i] = vt_seconds(n->times.tasks[i]);
    json_t *j =
        json_pack("{s:f, s:f, s:f, s:f, s:f, s:f, s:o, s:o, s:I, s:i, s:I, s:I}", "away_s",
                  (double)(int64_t)n->stats.away / (double)VT_SECOND, "ended_s",
                  vt_seconds(n->stats.ended_at), "busy_s", vt_seconds(busy(n)), "idle_s",
                  vt_seconds(n->stats.idle), "system_s", vt_seconds(n->times.system), "beside_s",
                  vt_seconds(n->stats.overlapped), "waits", waits_json(n), "tasks", json_tasks(tasks),
                  "memory_peak_bytes", (json_int_t)n->stats.memory_peak, "exit_code", n->end.exit_code,
                  "messages_sent", (json_int_t)n->stats.sent, "handlers", (json_int_t)n->stats.handlers);
    json_t *livelock = livelock_json(n, lines);
    if (livelock)
        json_set(j, "livelock", livelock);
    return j;
}

static json_t *files_json(const struct cfs *c)
{
    struct cfs_stats s = cfs_stats(c);
    return json_pack("{s:I, s:I, s:I, s:I, s:I, s:f}", "bytes_read", (json_int_t)s.bytes_read,
                     "bytes_written", (json_int_t)s.bytes_written, "cache_hits", (json_int_t)s.hits,
                     "disk_accesses", (json_int_t)s.disk_accesses, "disk_seeks", (json_int_t)s.disk_seeks,
                     "busiest_disk_s", vt_seconds(s.disk_busy));
}

/* The report of a deadlock, as touchstone run --deadlock writes it. */
static json_t *deadlock_json(const struct waitfor *w)
{
    char *text;
    size_t size;
    FILE *f = xchecked(open_memstream(&text, &size));
    waitfor_write_json(w, f);
    fclose(f);
    json_t *report = xchecked(json_loadb(text, size, 0, NULL));
    free(text);
    return report;
}

static json_t *machine_json(const struct machine *m, const struct race_reports *races)
{
    static const char *const OUTCOMES[] = {"ended", "failed", "deadlock", "stopped"};
    char digest[17];
    snprintf(digest, sizeof digest, "%016" PRIx64, m->sys.digest);
    json_t *root = json_pack(
        "{s:s, s:o, s:o, s:i, s:s, s:f, s:f, s:s, s:I, s:I, s:o, s:o, s:o}", "format", "touchstone run 1",
        "program", json_text(m->options.programs[0].argv[0]), "machine", json_text(m->sys.cfg->name), "nodes",
        (int)machine_nodes(m), "outcome", OUTCOMES[m->outcome], "virtual_time_s", vt_seconds(m->end),
        "wall_time_s", m->wall_s, "digest", digest, "messages", (json_int_t)m->sys.messages, "bytes",
        (json_int_t)m->sys.bytes, "arguments", json_texts(m->options.programs[0].argv + 1), "settings",
        json_texts(m->sys.cfg->set), "host_files", json_texts(m->sys.host_files));
    json_t *nodes = json_array();
    struct backtrace_lines *lines = backtrace_lines_new();
    for (uint32_t k = 0; k < machine_nodes(m); k++)
        json_append(nodes, node_json(m->sys.nodes[k], lines));
    if (m->sys.absent_count)
        json_set(root, "absent", absent_json(&m->sys));
    json_set(root, "node", nodes);
    if (m->sys.host)
        json_set(root, "host", node_json(m->sys.host, lines));
    backtrace_lines_free(lines);
    if (m->sys.cfs)
        json_set(root, "files", files_json(m->sys.cfs));
    if (m->waits)
        json_set(root, "deadlock", deadlock_json(m->waits));
    if (races->checked)
        json_set(root, "races", race_json(races));
    if (m->message)
        json_set(root, "message", json_text(m->message));
    return root;
}

char *summary_json(const struct machine *m, const struct race_reports *races, const char *path)
{
    return json_file_write(machine_json(m, races), path);
}
