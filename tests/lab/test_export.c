/* test_export.c - what is exported of a trace is what is in the trace, as programs of others read it:
 * Python's json and csv, pajeng, otf2-print; and for PICL a reader made from the format's description
 * (read_export.py). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "lab/export/csv_table.h"
#include "lab/export/export.h"
#include "made_trace.h"

static char folder[] = "/tmp/export.XXXXXX";

static void add_handler(struct trace *t, int32_t node, int32_t type, int32_t message, vtime begin, vtime end)
{
    struct trace_node *n = &t->nodes[node];
    if (!n->handlers++)
        n->first_handler = t->handler_count;
    t->handlers[t->handler_count++] = (struct trace_handler){.due = begin - 1,
                                                             .begin = begin,
                                                             .entered = begin,
                                                             .left = end,
                                                             .end = end,
                                                             .node = node,
                                                             .type = type,
                                                             .message = message,
                                                             .stack = TRACE_NONE};
}

static void add_system(struct trace *t, int32_t node, enum trace_task task, vtime begin, vtime end)
{
    struct trace_node *n = &t->nodes[node];
    if (!n->systems++)
        n->first_system = t->system_count;
    t->systems[t->system_count++] =
        (struct trace_system){.begin = begin, .end = end, .charged = begin, .node = node, .task = task};
}

static void drop(struct trace *t)
{
    for (int32_t i = 0; i < t->name_count; i++)
        free(t->names[i]);
    void *const tables[] = {t->names,    t->classes, t->nodes,    t->calls, t->waits,
                            t->handlers, t->systems, t->messages, t->blocks};
    for (size_t i = 0; i < sizeof tables / sizeof *tables; i++)
        free(tables[i]);
}

/* Of what happened to a node: what a reader must find. */
struct sums {
    vtime computing, waiting, system;
};

static struct sums sums_of(const struct trace *t, int32_t node)
{
    struct sums s = {0};
    struct trace_pieces p = {0};
    trace_pieces(t, node, &p);
    for (size_t i = 0; i < p.count; i++) {
        vtime length = p.list[i].end - p.list[i].begin;
        if (p.list[i].state == TRACE_COMPUTING)
            s.computing += length;
        else if (p.list[i].state == TRACE_WAITING)
            s.waiting += length;
        else if (p.list[i].state != TRACE_ENDED)
            s.system += length;
    }
    free(p.list);
    return s;
}

/* The lines that read_export.py prints of a trace whose messages from `first` on, and count of them, are
 * told. */
static char *expected(const struct trace *t, const int32_t *messages, size_t count)
{
    char *text;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    for (int32_t i = 0; i < t->node_count; i++) {
        struct sums s = sums_of(t, i);
        fprintf(f, "%s computing %" PRIu64 " waiting %" PRIu64 " system %" PRIu64 "\n", t->nodes[i].name,
                s.computing, s.waiting, s.system);
    }
    for (size_t i = 0; i < count; i++) {
        const struct trace_message *m = &t->messages[messages[i]];
        fprintf(f, "message %s to %s type %d bytes %" PRIu64 "\n", t->nodes[m->from].name,
                t->nodes[m->to].name, m->type, m->bytes);
    }
    fclose(f);
    return text;
}

/* What a command prints; malloc'd. Fails unless the command succeeds. */
static char *said(const char *command)
{
    char *text = calloc(1, 1 << 20);
    FILE *p = popen(command, "r");
    size_t got = fread(text, 1, (1 << 20) - 1, p);
    if (pclose(p) != 0)
        fail_msg("%s failed: %s", command, text);
    text[got] = '\0';
    return text;
}

static char *exported(const struct trace *t, enum export_format format, enum export_table table)
{
    char *error = NULL;
    static int count;
    char *out = xasprintf("%s/%d.%s", folder, ++count, export_format_name(format));
    struct export_request r = {.format = format, .table = table, .out = out};
    if (!export_write(t, &r, &error))
        fail_msg("%s", error);
    return out;
}

static char *read_back(const struct trace *t, enum export_format format)
{
    char *out = exported(t, format, EXPORT_TABLES);
    char *command = xasprintf("python3 tests/lab/read_export.py %s %s 2>&1", export_format_name(format), out);
    char *text = said(command);
    free(command);
    free(out);
    return text;
}

static void reads_back_as(const struct trace *t, const int32_t *messages, size_t count)
{
    char *expect = expected(t, messages, count);
    for (enum export_format f = 0; f < EXPORT_FORMATS; f++) {
        char *text = read_back(t, f);
        if (strcmp(text, expect) != 0)
            fail_msg("%s reads back as\n%s\nnot\n%s", export_format_name(f), text, expect);
        free(text);
    }
    free(expect);
}

/* --- traces --- */

/* Nodes 0 and 1 exchange messages; times are such that rounding anywhere would show. */
static struct trace exchange(void)
{
    struct trace t = made_trace(2, 5000000000007);
    int32_t a = made_call(&t, 0, "csend", TRACE_SENDS, 7, 1000000000001, 1000000450003);
    made_wait(&t, 1000000200001, 1000000300002);
    int32_t b = made_call(&t, 0, "crecv", TRACE_RECEIVES, 8, 1000001000000, 2000000000011);
    made_wait(&t, 1000001000003, 1999999999999);
    int32_t c = made_call(&t, 1, "crecv", TRACE_RECEIVES, 7, 900000000000, 1000002000000);
    made_wait(&t, 900000000013, 1000001900000);
    int32_t d = made_call(&t, 1, "csend", TRACE_SENDS, 8, 1500000000001, 1500000000777);
    made_message(&t, a, c, 1, 1024, 1000000200000, 1000000210000, 1000001000000, 1000001900000);
    made_message(&t, d, b, 0, 8, 1500000000777, 1500000000778, 1999999000000, 1999999999999);
    return t;
}

static void sums_and_messages(void **state)
{
    (void)state;
    struct trace t = exchange();
    reads_back_as(&t, (int32_t[]){0, 1}, 2);
    drop(&t);
}

/* A handler interrupts computing and calls csend; another runs within a call that waits; the system steals
 * time. */
static void handlers_nest(void **state)
{
    (void)state;
    struct trace t = made_trace(2, 100000);
    int32_t a = made_call(&t, 0, "csend", TRACE_SENDS, 1, 10, 20);
    int32_t b = made_call(&t, 0, "csend", TRACE_SENDS, 2, 5000, 5010);
    int32_t r = made_call(&t, 0, "crecv", TRACE_RECEIVES, 3, 6000, 90001);
    made_wait(&t, 6010, 90000);
    int32_t answer = made_call(&t, 1, "csend", TRACE_SENDS, 3, 1100, 1200);
    t.calls[answer].in_handler = true;
    int32_t w = made_call(&t, 1, "crecv", TRACE_RECEIVES, 99, 2000, 80000);
    made_wait(&t, 2010, 8000);
    made_wait(&t, 8500, 80000);
    int32_t first = made_message(&t, a, TRACE_NONE, 1, 100, 20, 30, 900, 990);
    made_message(&t, answer, r, 0, 300, 1200, 1300, 80000, 89000);
    int32_t second = made_message(&t, b, TRACE_NONE, 1, 200, 5010, 5020, 7000, 7900);
    add_system(&t, 1, TRACE_RECEIVING, 900, 990);
    add_system(&t, 1, TRACE_RECEIVING, 7900, 8000);
    add_handler(&t, 1, 1, first, 1000, 1500);
    add_handler(&t, 1, 2, second, 8000, 8500);
    t.waits[t.calls[w].first_wait].end = 7900; /* the rest is the system's */
    reads_back_as(&t, (int32_t[]){0, 1, 2}, 3);
    drop(&t);
}

/* A call that sends to several nodes, one that takes two messages, one that takes no time. */
static void several_messages_a_call(void **state)
{
    (void)state;
    struct trace t = made_trace(3, 9000);
    int32_t all = made_call(&t, 0, "csend", TRACE_SENDS, 5, 100, 400);
    int32_t none = made_call(&t, 0, "mynode", TRACE_OTHER, 0, 400, 400);
    int32_t back = made_call(&t, 1, "csend", TRACE_SENDS, 6, 50, 90);
    int32_t one = made_call(&t, 1, "crecv", TRACE_RECEIVES, 5, 200, 800);
    made_wait(&t, 210, 790);
    int32_t two = made_call(&t, 2, "gsync", TRACE_GLOBAL, 5, 200, 900);
    made_wait(&t, 250, 850);
    made_message(&t, back, two, 2, 16, 90, 91, 92, 93);
    made_message(&t, all, one, 1, 10, 200, 210, 700, 790);
    made_message(&t, all, two, 2, 11, 300, 310, 800, 850);
    t.calls[all].sent = 1;
    t.messages[0].taken = 240;
    (void)none;
    reads_back_as(&t, (int32_t[]){0, 1, 2}, 3);
    drop(&t);
}

/* A message to all nodes, which node 1 has passed on to node 2: for readers it is from node 0, whose call it
 * was. */
static void a_message_passed_on(void **state)
{
    (void)state;
    struct trace t = made_trace(3, 9000);
    int32_t all = made_call(&t, 0, "csend", TRACE_SENDS, 5, 100, 400);
    int32_t one = made_call(&t, 1, "crecv", TRACE_RECEIVES, 5, 200, 800);
    made_wait(&t, 210, 790);
    int32_t two = made_call(&t, 2, "crecv", TRACE_RECEIVES, 5, 200, 1900);
    made_wait(&t, 250, 1850);
    made_message(&t, all, one, 1, 10, 300, 310, 700, 790);
    int32_t second = made_message(&t, all, two, 2, 10, 750, 760, 1800, 1850);
    t.calls[all].sent = 0;
    t.messages[second].from = 1;
    for (enum export_format f = 0; f < EXPORT_CSV; f++) {
        char *text = read_back(&t, f);
        assert_non_null(strstr(text, "message node 0 to node 2 type 5 bytes 10\n"));
        assert_null(strstr(text, "message node 1 to node 2"));
        free(text);
    }
    drop(&t);
}

/* What has only one end, or one at a service, is no arrow; unfinished calls end with their node's time. */
static void ends_missing(void **state)
{
    (void)state;
    struct trace t = made_trace(2, 1000);
    int32_t a = made_call(&t, 0, "csend", TRACE_SENDS, 5, 100, 110);
    int32_t b = made_call(&t, 0, "cwrite", TRACE_FILES, 5, 200, 210);
    int32_t r = made_call(&t, 1, "crecv", TRACE_RECEIVES, 6, 300, VT_NEVER);
    made_wait(&t, 310, 1000);
    t.calls[r].unfinished = true;
    made_message(&t, a, TRACE_NONE, 1, 10, 110, 120, 130, VT_NEVER);
    made_message(&t, b, TRACE_NONE, TRACE_NONE, 10, 210, 220, 230, 240);
    t.waits[0].end = 1000;
    t.nodes[0].end = 700;
    struct sums s = sums_of(&t, 0);
    assert_true(s.computing == 700 - 20);
    char *json = read_back(&t, EXPORT_JSON);
    assert_null(strstr(json, "message"));
    assert_non_null(strstr(json, "node 1 computing 300 waiting 690 system 10\n"));
    free(json);
    char *picl = read_back(&t, EXPORT_PICL);
    assert_non_null(strstr(picl, "node 0 computing 680 waiting 0 system 20\n"));
    free(picl);
    drop(&t);
}

/* A trace cut to an interval: nothing is written outside of it. */
static void a_cut_trace(void **state)
{
    (void)state;
    struct trace t = exchange();
    t.from = 1000000100000, t.to = 1700000000000;
    t.messages[0].sending = TRACE_NONE; /* as if the call were not in memory */
    for (int32_t i = 0; i < t.node_count; i++)
        t.nodes[i].end = t.to;
    t.calls[0].sent = TRACE_NONE;
    reads_back_as(&t, (int32_t[]){1}, 1);
    drop(&t);
}

static void nothing_happened(void **state)
{
    (void)state;
    struct trace t = made_trace(3, 12);
    reads_back_as(&t, NULL, 0);
    drop(&t);
}

static void nodes_not_traced(void **state)
{
    (void)state;
    struct trace t = exchange();
    t.nodes[0].traced = false;
    t.messages[0].sending = t.messages[1].taking = TRACE_NONE;
    for (enum export_format f = 0; f < EXPORT_FORMATS; f++) {
        char *text = read_back(&t, f);
        struct sums s = sums_of(&t, 1);
        char *line = xasprintf("node 1 computing %" PRIu64 " waiting %" PRIu64 " system %" PRIu64 "\n",
                               s.computing, s.waiting, s.system);
        assert_non_null(strstr(text, line));
        assert_null(strstr(text, "node 0 computing 1"));
        free(text);
        free(line);
    }
    drop(&t);
}

/* As in a damaged trace: what is made of it nobody can say, but all formats are written. */
static void a_node_that_ends_before_its_calls(void **state)
{
    (void)state;
    struct trace t = exchange();
    t.nodes[0].end = t.nodes[1].end = t.from + 1;
    for (enum export_format f = 0; f < EXPORT_FORMATS; f++)
        free(exported(&t, f, EXPORT_TABLES));
    drop(&t);
}

/* --- names and tables --- */

static void formats_by_ending(void **state)
{
    (void)state;
    assert_int_equal(export_format_of_file("a/b.json"), EXPORT_JSON);
    assert_int_equal(export_format_of_file("b.trf"), EXPORT_PICL);
    assert_int_equal(export_format_of_file("b.json.gz"), EXPORT_FORMATS);
    assert_int_equal(export_format_of_file("json"), EXPORT_FORMATS);
    assert_int_equal(export_format_of_file(".csv"), EXPORT_FORMATS);
    assert_int_equal(export_format_named("otf2"), EXPORT_OTF2);
    assert_int_equal(export_format_named("otf"), EXPORT_FORMATS);
    assert_int_equal(export_table_named("waits"), EXPORT_WAITS);
}

static void text_is_quoted(void **state)
{
    (void)state;
    struct trace t = exchange();
    t.command = (char *)(uintptr_t) "run \"a b\", \\n\tx";
    t.machine = (char *)(uintptr_t) "a \"machine\"";
    for (enum export_format f = 0; f < EXPORT_FORMATS; f++) {
        char *text = read_back(&t, f);
        assert_true(strlen(text) > 0);
        free(text);
    }
    t.machine = (char *)(uintptr_t) "m\u00e4chine \xfc"; /* JSON is UTF-8 */
    free(read_back(&t, EXPORT_JSON));
    drop(&t);
}

/* All cells of all tables are as long as the first row; times have twelve digits. */
static void tables_are_tables(void **state)
{
    (void)state;
    struct trace t = exchange();
    made_block(&t, 3, 100, 200);
    add_handler(&t, 1, 4, 1, 3000000000000, 3000000000001);
    add_system(&t, 1, TRACE_FEEDING, 3100000000000, 3100000000001);
    for (enum export_table table = 0; table < EXPORT_TABLES; table++) {
        char *out = exported(&t, EXPORT_CSV, table);
        char *command = xasprintf("python3 tests/lab/read_export.py table %s 2>&1", out);
        char *text = said(command);
        int rows = atoi(text);
        const int EXPECTED[] = {
            [EXPORT_PIECES] = 13, [EXPORT_CALLS] = 4,    [EXPORT_WAITS] = 3, [EXPORT_HANDLERS] = 1,
            [EXPORT_SYSTEMS] = 1, [EXPORT_MESSAGES] = 2, [EXPORT_BLOCKS] = 1};
        if (table != EXPORT_PIECES)
            assert_int_equal(rows, EXPECTED[table]);
        assert_true(rows > 0);
        free(text);
        free(command);
        free(out);
    }
    drop(&t);
}

/* Thousands of lines a node, more than a buffer holds, come out in order of time. */
static void many_lines_in_order(void **state)
{
    (void)state;
    struct trace t = made_trace(4, 4000000);
    for (int32_t n = 0; n < 4; n++)
        for (int32_t i = 0; i < 240; i++)
            made_call(&t, n, "flick", TRACE_OTHER, i, (vtime)(1000 + 7919 * i + n),
                      (vtime)(1500 + 7919 * i + 2 * n));
    reads_back_as(&t, NULL, 0);
    drop(&t);
}

/* --- files --- */

static void folders_are_not_overwritten(void **state)
{
    (void)state;
    struct trace t = exchange();
    char *out = exported(&t, EXPORT_OTF2, EXPORT_TABLES), *error = NULL;
    struct export_request r = {.format = EXPORT_OTF2, .out = out};
    assert_false(export_write(&t, &r, &error));
    assert_non_null(strstr(error, "already there"));
    free(error);
    free(out);
    drop(&t);
}

/* As on a terminal that has waited for more than a second. */
static char *shown_of_table(const struct trace *t, enum export_table table)
{
    char *shown;
    size_t size;
    FILE *to = open_memstream(&shown, &size), *out = tmpfile();
    struct export_progress p = export_progress_begin(to, t->node_count);
    p.began -= 2;
    csv_table_write(t, table, out, &p);
    fclose(out);
    fclose(to);
    return shown;
}

static void a_terminal_sees_how_much_of_a_table_is_written(void **state)
{
    (void)state;
    struct trace t = exchange();
    for (enum export_table table = 0; table < EXPORT_TABLES; table++) {
        char *shown = shown_of_table(&t, table);
        if (table == EXPORT_PIECES)
            assert_non_null(strstr(shown, "\r1 of 2 nodes written"));
        else if (table == EXPORT_MESSAGES)
            assert_non_null(strstr(shown, "\r0 of 2 rows written"));
        free(shown);
    }
    drop(&t);
}

static void no_file_is_left_of_a_failure(void **state)
{
    (void)state;
    struct trace t = exchange();
    for (enum export_format f = 0; f < EXPORT_FORMATS; f++) {
        char *error = NULL;
        struct export_request r = {.format = f, .table = EXPORT_TABLES, .out = "/nowhere/at/all.x"};
        assert_false(export_write(&t, &r, &error));
        assert_non_null(strstr(error, "/nowhere/at/all"));
        free(error);
    }
    char *command = xasprintf("find %s -regex '.*x[.][A-Za-z0-9]*' | wc -l", folder);
    char *left = said(command);
    assert_int_equal(atoi(left), 0);
    free(left);
    free(command);
    drop(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sums_and_messages),
        cmocka_unit_test(handlers_nest),
        cmocka_unit_test(several_messages_a_call),
        cmocka_unit_test(a_message_passed_on),
        cmocka_unit_test(ends_missing),
        cmocka_unit_test(a_cut_trace),
        cmocka_unit_test(nothing_happened),
        cmocka_unit_test(nodes_not_traced),
        cmocka_unit_test(a_node_that_ends_before_its_calls),
        cmocka_unit_test(formats_by_ending),
        cmocka_unit_test(text_is_quoted),
        cmocka_unit_test(tables_are_tables),
        cmocka_unit_test(many_lines_in_order),
        cmocka_unit_test(folders_are_not_overwritten),
        cmocka_unit_test(a_terminal_sees_how_much_of_a_table_is_written),
        cmocka_unit_test(no_file_is_left_of_a_failure),
    };
    if (!mkdtemp(folder))
        return 1;
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    char *command = xasprintf("rm -rf %s", folder);
    if (system(command) != 0)
        failed++;
    free(command);
    return failed;
}
