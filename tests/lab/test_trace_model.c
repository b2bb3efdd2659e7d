/* test_trace_model.c - a trace that is recorded is the trace that is read; and where a node's time goes in
 * it. */
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <setjmp.h>
#include <stdio.h>
#include <unistd.h>
#include <cmocka.h>
#include "made_trace.h"
#include "trace/interned.h"
#include "trace/packer.h"
#include "trace/recorder.h"
#include "trace/unpacker.h"

/* --- numbers --- */

static void numbers_come_back(void **state)
{
    static const int64_t SIGNED[] = {0, 1, -1, 63, -64, 64, 8191, -8192, INT64_MAX, INT64_MIN};
    FILE *f = tmpfile();
    (void)state;
    struct packer *p = packer_new(f);
    uint8_t *at = packer_room(p, sizeof SIGNED / sizeof *SIGNED);
    for (size_t i = 0; i < sizeof SIGNED / sizeof *SIGNED; i++)
        put_signed(&at, SIGNED[i]);
    packer_wrote(p, at);
    for (uint64_t n = 0; n < 200000; n++) /* more than a block of the stream */
        pack(p, n * n * n);
    pack(p, UINT64_MAX);
    pack_bytes(p, "text", 4);
    packer_end(p);
    rewind(f);
    struct unpacker *u = unpacker_new(f);
    for (size_t i = 0; i < sizeof SIGNED / sizeof *SIGNED; i++)
        assert_true(unpack_signed(u) == SIGNED[i]);
    for (uint64_t n = 0; n < 200000; n++)
        assert_true(unpack(u) == n * n * n);
    assert_true(unpack(u) == UINT64_MAX);
    char *text = unpack_text(u, 4);
    assert_string_equal(text, "text");
    assert_true(unpacker_good(u));
    unpack_byte(u);
    assert_false(unpacker_good(u));
    free(text);
    unpacker_free(u);
    fclose(f);
}

static void strings_keep_their_numbers(void **state)
{
    struct interned *t = interned_new();
    char text[16];
    bool is_new;
    (void)state;
    for (int again = 0; again < 2; again++)
        for (uint32_t i = 0; i < 1000; i++) {
            snprintf(text, sizeof text, "name %u", i);
            assert_int_equal(interned_number(t, text, strlen(text), &is_new), i);
            assert_int_equal(is_new, !again);
        }
    assert_int_equal(interned_number(t, "", 0, &is_new), 1000);
    interned_free(t);
}

/* --- a whole file --- */

static json_t *head(void)
{
    return json_pack("{s:s, s:[s,s], s:s, s:s, s:s, s:{s:s, s:i, s:i, s:i, s:i, s:i, s:b, s:i}}", "version",
                     "1", "command", "touchstone", "run", "folder", "/", "program", "prog", "machine",
                     "ipsc860", "network", "shape", "hypercube", "nodes", 2, "rows", 0, "columns", 0,
                     "positions", 2, "services", 0, "host", 0, "addresses", 2);
}

/* Node 0 sends a long message, which waits for a channel; node 1 waits for it. */
static void record(struct recorder *r)
{
    struct recorded_wait wait = {
        .begin = 210, .end = 900, .busy = 90, .type = 7, .from = 0, .flags = WAIT_HAS_TYPE | WAIT_HAS_FROM};
    struct recorded_block block = {.channel = 1, .begin = 400, .end = 500};
    struct recorded_call send = {.address = 0,
                                 .name = recorder_name(r, "csend"),
                                 .flags = CALL_HAS_TYPE | CALL_SENT,
                                 .type = -7,
                                 .begin = 100,
                                 .ordered = 100,
                                 .end = 150,
                                 .sent_order = 5,
                                 .sent_count = 1};
    struct recorded_call receive = {.address = 1,
                                    .name = recorder_name(r, "crecv"),
                                    .flags = CALL_HAS_TYPE | CALL_TOOK,
                                    .type = 7,
                                    .begin = 200,
                                    .ordered = 900,
                                    .end = 950,
                                    .taken_source = 0,
                                    .taken_order = 5,
                                    .taken_at = 920,
                                    .waits = &wait,
                                    .wait_count = 1};
    struct recorded_message message = {.source = 0,
                                       .order = 5,
                                       .from = 0,
                                       .to = 1,
                                       .type = 7,
                                       .bytes = 1000,
                                       .is_long = true,
                                       .sent = 150,
                                       .times = {200, 250, 400, 500, VT_NEVER, 800, 890},
                                       .blocks = &block,
                                       .block_count = 1};
    recorder_call(r, &send);
    recorder_system(r, 1, 1, 700, 710, 800);
    recorder_message(r, &message);
    recorder_call(r, &receive);
    recorder_node_end(r, 0, 300);
    recorder_node_end(r, 1, 1000);
}

static char *written(const struct recorder_options *wanted)
{
    char *path = xstrdup("/tmp/test_trace_model.XXXXXX");
    int fd = mkstemp(path);
    FILE *f = fdopen(fd, "w");
    struct recorder_options o = *wanted;
    json_t *first = head();
    o.out = f, o.addresses = 2;
    struct recorder *r = recorder_new(&o, first);
    record(r);
    recorder_end(r, 1000, 0x0123456789abcdef);
    json_decref(first);
    fclose(f);
    return path;
}

static struct trace *read_back(const struct recorder_options *wanted, const struct trace_selection *s)
{
    char *path = written(wanted), *error = NULL;
    struct trace *t = trace_load(path, s, &error);
    if (!t)
        fail_msg("%s", error);
    unlink(path);
    free(path);
    return t;
}

static const struct recorder_options ALL = {.to = VT_NEVER};

static void a_file_is_read_as_written(void **state)
{
    (void)state;
    struct trace *t = read_back(&ALL, NULL);
    assert_true(t->complete);
    assert_true(t->digest == 0x0123456789abcdef && t->end == 1000 && t->to == 1000);
    assert_string_equal(t->command, "touchstone run");
    assert_int_equal(t->call_count, 2);
    assert_int_equal(t->nodes[0].end, 300);
    const struct trace_call *send = &t->calls[0], *receive = &t->calls[1];
    assert_string_equal(t->names[send->name], "csend");
    assert_int_equal(send->type, -7);
    assert_int_equal(send->sent, 0);
    assert_int_equal(send->taken, TRACE_NONE);
    assert_int_equal(receive->taken, 0);
    assert_int_equal(receive->ordered, 900);
    const struct trace_wait *w = &t->waits[receive->first_wait];
    assert_int_equal(receive->waits, 1);
    assert_true(w->begin == 210 && w->end == 900 && w->idle == 600 && w->from == 0 && w->type == 7 &&
                !w->sends);
    const struct trace_message *m = &t->messages[0];
    assert_true(m->is_long && m->bytes == 1000 && m->sent == 150 && m->asked == 200 && m->granted == 250);
    assert_true(m->entered == 400 && m->moved == 500 && m->freed == VT_NEVER && m->left == 800 &&
                m->complete == 890);
    assert_true(m->taken == 920 && m->sending == 0 && m->taking == 1);
    assert_true(m->blocks == 1 && t->blocks[0].begin == 400 && t->blocks[0].end == 500 &&
                t->blocks[0].channel == 1);
    assert_true(t->systems[0].charged == 700 && t->systems[0].begin == 710 && t->systems[0].end == 800);
    assert_int_equal(t->systems[0].task, TRACE_RECEIVING);
    trace_free(t);
}

/* What the recorder leaves out is what a reader of the whole leaves out. */
static void a_part_is_what_overlaps(void **state)
{
    static const bool SECOND[2] = {false, true};
    (void)state;
    const struct recorder_options late = {.from = 160, .to = 500},
                                  second = {.to = VT_NEVER, .nodes = SECOND, .node_count = 2};
    struct trace *t = read_back(&late, NULL),
                 *u = read_back(&ALL, &(struct trace_selection){.from = 160, .to = 500});
    assert_int_equal(t->call_count, 1); /* crecv overlaps, csend has ended */
    assert_int_equal(t->message_count, 1);
    assert_int_equal(t->system_count, 0);
    assert_int_equal(u->call_count, 1);
    assert_int_equal(u->message_count, 1);
    assert_int_equal(u->system_count, 0);
    assert_int_equal(u->messages[0].sending, TRACE_NONE);
    trace_free(t);
    trace_free(u);
    t = read_back(&ALL, &(struct trace_selection){.nodes = SECOND, .node_count = 2});
    assert_false(t->nodes[0].traced);
    assert_int_equal(t->call_count, 1);
    trace_free(t);
    t = read_back(&second, NULL);
    assert_int_equal(t->message_count, 1);
    trace_free(t);
}

/* Whatever a file has from some byte on, the reader neither crashes nor loops. */
static void a_damaged_file_does_no_harm(void **state)
{
    char *path = written(&ALL), *error = NULL;
    (void)state;
    FILE *f = fopen(path, "r+");
    fseek(f, 0, SEEK_END);
    long size = ftell(f);
    for (long at = 0; at < size; at++) {
        fseek(f, at, SEEK_SET);
        int before = fgetc(f);
        fseek(f, at, SEEK_SET);
        fputc(before ^ 0x55, f);
        fflush(f);
        trace_free(trace_load(path, NULL, &error));
        free(error);
        error = NULL;
        fseek(f, at, SEEK_SET);
        fputc(before, f);
    }
    fclose(f);
    unlink(path);
    free(path);
}

/* Is a trace read whose network is that one? Takes over the network. */
static bool is_read(json_t *network)
{
    char *path = xstrdup("/tmp/test_trace_model.XXXXXX"), *error = NULL;
    struct recorder_options o = ALL;
    json_t *first = head();
    json_object_set_new(first, "network", network);
    o.out = fdopen(mkstemp(path), "w"), o.addresses = 2;
    recorder_end(recorder_new(&o, first), 1000, 0);
    json_decref(first);
    fclose(o.out);
    struct trace *t = trace_load(path, NULL, &error);
    bool read = t;
    if (!t)
        assert_non_null(strstr(error, "head is damaged"));
    free(error);
    trace_free(t);
    unlink(path);
    free(path);
    return read;
}

static void a_network_that_no_run_has_is_refused(void **state)
{
    (void)state;
    json_t *mesh = json_pack("{s:s, s:i, s:i, s:i, s:i}", "shape", "mesh", "nodes", 2, "rows", 1, "columns",
                             2, "addresses", 2);
    assert_true(is_read(json_incref(mesh)));
    json_object_set_new(mesh, "host", json_true());
    assert_false(is_read(json_incref(mesh)));
    json_object_del(mesh, "host");
    json_object_set_new(mesh, "rows", json_integer(UINT32_MAX));
    assert_false(is_read(mesh));
}

/* --- pieces --- */

struct expected {
    enum trace_state state;
    vtime end;
};

static void check_pieces(const struct trace *t, int32_t node, const struct expected *e, size_t count)
{
    struct trace_pieces p = {0};
    vtime at = t->from;
    trace_pieces(t, node, &p);
    assert_int_equal(p.count, count);
    for (size_t i = 0; i < count; i++) {
        assert_true(p.list[i].begin == at);
        assert_int_equal(p.list[i].state, e[i].state);
        assert_true(p.list[i].end == e[i].end);
        at = p.list[i].end;
    }
    free(p.list);
}

static void add_system(struct trace *t, int32_t node, vtime charged, vtime begin, vtime end)
{
    if (!t->nodes[node].systems++)
        t->nodes[node].first_system = t->system_count;
    t->systems[t->system_count++] =
        (struct trace_system){.charged = charged, .begin = begin, .end = end, .node = node};
}

static void the_system_cuts_computing_and_waiting(void **state)
{
    struct trace t = made_trace(1, 1000);
    (void)state;
    made_call(&t, 0, "crecv", TRACE_RECEIVES, 1, 300, 600);
    made_wait(&t, 350, 550);
    t.calls[0].ordered = 550;
    t.waits[0].idle -= 20;
    add_system(&t, 0, 100, 100, 150); /* while it computes */
    add_system(&t, 0, 120, 150, 160); /* comes meanwhile, and waits for the first */
    add_system(&t, 0, 400, 400, 420); /* while it waits */
    add_system(&t, 0, 570, 570, 590); /* in the call, behind its turn: delays what follows */
    const struct expected e[] = {{TRACE_COMPUTING, 100}, {TRACE_IN_SYSTEM, 150}, {TRACE_IN_SYSTEM, 160},
                                 {TRACE_COMPUTING, 300}, {TRACE_IN_CALL, 350},   {TRACE_WAITING, 400},
                                 {TRACE_IN_SYSTEM, 420}, {TRACE_WAITING, 550},   {TRACE_IN_CALL, 600},
                                 {TRACE_IN_SYSTEM, 620}, {TRACE_COMPUTING, 1000}};
    check_pieces(&t, 0, e, sizeof e / sizeof *e);
    made_free(&t);
}

/* The run counts more, or less, as the system's than lies in the wait. */
static void a_wait_rests_for_its_idle_time(void **state)
{
    struct trace t = made_trace(1, 1000);
    (void)state;
    made_call(&t, 0, "crecv", TRACE_RECEIVES, 1, 300, 600);
    made_wait(&t, 350, 550);
    t.calls[0].ordered = 550;
    add_system(&t, 0, 500, 500, 520);
    t.waits[0].idle = 100;
    const struct expected more[] = {{TRACE_COMPUTING, 300}, {TRACE_IN_CALL, 350},   {TRACE_WAITING, 450},
                                    {TRACE_IN_SYSTEM, 500}, {TRACE_IN_SYSTEM, 520}, {TRACE_IN_SYSTEM, 550},
                                    {TRACE_IN_CALL, 600},   {TRACE_COMPUTING, 1000}};
    check_pieces(&t, 0, more, sizeof more / sizeof *more);
    t.waits[0].idle = 190;
    const struct expected less[] = {{TRACE_COMPUTING, 300}, {TRACE_IN_CALL, 350},   {TRACE_WAITING, 500},
                                    {TRACE_WAITING, 510},   {TRACE_IN_SYSTEM, 520}, {TRACE_WAITING, 550},
                                    {TRACE_IN_CALL, 600},   {TRACE_COMPUTING, 1000}};
    check_pieces(&t, 0, less, sizeof less / sizeof *less);
    made_free(&t);
}

static void a_handler_lies_on_top(void **state)
{
    struct trace t = made_trace(1, 1000);
    (void)state;
    made_call(&t, 0, "crecv", TRACE_RECEIVES, 1, 100, 800);
    made_wait(&t, 150, 300);
    made_wait(&t, 500, 750);
    int32_t inner = made_call(&t, 0, "csend", TRACE_SENDS, 2, 350, 400);
    t.calls[inner].in_handler = true;
    t.handlers[t.handler_count++] = (struct trace_handler){
        .due = 300, .begin = 300, .entered = 320, .left = 480, .end = 500, .message = TRACE_NONE};
    t.nodes[0].handlers = 1;
    t.nodes[0].end = 900;
    const struct expected e[] = {{TRACE_COMPUTING, 100}, {TRACE_IN_CALL, 150},   {TRACE_WAITING, 300},
                                 {TRACE_IN_SYSTEM, 320}, {TRACE_COMPUTING, 350}, {TRACE_IN_CALL, 400},
                                 {TRACE_COMPUTING, 480}, {TRACE_IN_SYSTEM, 500}, {TRACE_WAITING, 750},
                                 {TRACE_IN_CALL, 800},   {TRACE_COMPUTING, 900}, {TRACE_ENDED, 1000}};
    check_pieces(&t, 0, e, sizeof e / sizeof *e);
    made_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(numbers_come_back),
                                       cmocka_unit_test(strings_keep_their_numbers),
                                       cmocka_unit_test(a_file_is_read_as_written),
                                       cmocka_unit_test(a_part_is_what_overlaps),
                                       cmocka_unit_test(a_damaged_file_does_no_harm),
                                       cmocka_unit_test(a_network_that_no_run_has_is_refused),
                                       cmocka_unit_test(the_system_cuts_computing_and_waiting),
                                       cmocka_unit_test(a_wait_rests_for_its_idle_time),
                                       cmocka_unit_test(a_handler_lies_on_top)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
