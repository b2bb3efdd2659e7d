/* test_explain.c - the account of a row's time: what it is made of, and that figures which do not add up are refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "lab/tables/explain.h"

static void assert_near(double a, double b)
{
    assert_true(fabs(a - b) < 1e-9);
}

static struct paper_message messages[] = {{6, 6, (char *)"chunks"}};
static const struct paper paper = {.messages = messages, .message_count = 1};
static const struct paper_row row = {.nodes = 2, .group = 2, .paper = {.total_s = 10}};

/* A host that reads for 9 s, and a slave that computes for 4 s and waits for 5; both from 1 s to 10 s, then 1 s more. */
static struct outcome measured(void)
{
    static const char *const NAMES[] = {
        "reading", "helping",       "computing",   "answering",  "packing",    "news",    "collecting",
        "sending", "wait_requests", "wait_slaves", "wait_chunk", "wait_order", "dealing", "other"};
    struct outcome o = {.printed = json_object()};
    char key[64];
    for (int slave = 0; slave < 2; slave++) {
        const char *name = slave ? "slaves" : "hosts";
        for (size_t i = 0; i < sizeof NAMES / sizeof *NAMES; i++) {
            snprintf(key, sizeof key, "times_%s_%s_s", name, NAMES[i]);
            json_object_set_new(o.printed, key, json_real(0));
        }
        snprintf(key, sizeof key, "times_%s_began_s", name);
        json_object_set_new(o.printed, key, json_real(1));
        snprintf(key, sizeof key, "times_%s_ended_s", name);
        json_object_set_new(o.printed, key, json_real(10));
    }
    json_object_set_new(o.printed, "total_s", json_real(9));
    json_object_set_new(o.printed, "times_hosts_reading_s", json_real(9));
    json_object_set_new(o.printed, "times_slaves_computing_s", json_real(4));
    json_object_set_new(o.printed, "times_slaves_wait_chunk_s", json_real(5));
    json_object_set_new(o.printed, "times_layer_3",
                        json_pack("[i,f,f,f,f,f,f,f]", 0, 1.0, 9.0, 9.0, 0.0, 0.0, 0.0, 0.0));
    o.run = json_loads("{\"node\": ["
                       "{\"ended_s\": 11, \"busy_s\": 8, \"idle_s\": 0, \"system_s\": 3, \"beside_s\": 0.5,"
                       " \"waits\": [], \"tasks\": {\"interrupts_s\": 3.5}},"
                       "{\"ended_s\": 11, \"busy_s\": 5, \"idle_s\": 6, \"system_s\": 0, \"beside_s\": 0,"
                       " \"waits\": [{\"call\": \"msgwait\", \"type\": 6, \"idle_s\": 5, \"waits\": 2},"
                       " {\"call\": \"read\", \"idle_s\": 1, \"waits\": 1}], \"tasks\": {}}]}",
                       0, NULL);
    assert_non_null(o.run);
    return o;
}

static const struct explain_line *find(const struct explain_part *part, const char *label)
{
    for (size_t i = 0; i < part->count; i++)
        if (strcmp(part->lines[i].label, label) == 0)
            return &part->lines[i];
    fail_msg("no line %s", label);
    return NULL;
}

static void both_accounts_cover_all_time(void **state)
{
    (void)state;
    char *error = NULL;
    struct outcome o = measured();
    struct explain *e = explain_read(&paper, &row, 1, &o, &o, &error);
    assert_non_null(e);
    for (int c = 0; c < EXPLAIN_CLASSES; c++) {
        assert_int_equal(e->nodes[c], 1);
        assert_near(explain_sum(&e->program, c), 9);
        assert_near(explain_sum(&e->processor, c) - e->around_s[c], 9);
        assert_near(e->around_s[c], 2);
    }
    explain_free(e);
    outcome_clear(&o);
}

static void each_second_is_in_its_line(void **state)
{
    (void)state;
    char *error = NULL;
    struct outcome o = measured();
    struct explain *e = explain_read(&paper, &row, 1, &o, &o, &error);
    assert_non_null(e);
    assert_near(find(&e->program, "reading slices")->s[EXPLAIN_HOSTS], 9);
    assert_near(find(&e->program, "waiting for a chunk")->s[EXPLAIN_SLAVES], 5);
    assert_near(find(&e->processor, "computing")->s[EXPLAIN_HOSTS], 8);
    assert_near(find(&e->processor, "system: interrupts")->s[EXPLAIN_HOSTS], 3.5);
    assert_near(find(&e->processor, "less system beside it")->s[EXPLAIN_HOSTS], -0.5);
    assert_near(find(&e->processor, "idle: msgwait, chunks")->s[EXPLAIN_SLAVES], 5);
    assert_near(find(&e->processor, "idle: read")->s[EXPLAIN_SLAVES], 1);
    assert_int_equal(e->layer_count, 1);
    assert_int_equal(e->layers[0].layer, 3);
    explain_free(e);
    outcome_clear(&o);
}

/* What is said when one figure is changed. */
static void refused(const char *key, double value, const char *expected)
{
    char *error = NULL;
    struct outcome o = measured();
    json_object_set_new(o.printed, key, json_real(value));
    assert_null(explain_read(&paper, &row, 1, &o, &o, &error));
    assert_string_equal(error, expected);
    free(error);
    outcome_clear(&o);
}

static void what_does_not_add_up_is_refused(void **state)
{
    (void)state;
    refused("times_hosts_reading_s", 8.5, "the hosts' activities add up to 8.500000 s, not 9.000000");
    refused("total_s", 9.5, "the hosts ran for 9.000000 s, but 1 times the total time is 9.500000 s");
    char *error = NULL;
    struct outcome o = measured();
    json_object_set_new(json_array_get(json_object_get(o.run, "node"), 1), "busy_s", json_real(4));
    assert_null(explain_read(&paper, &row, 1, &o, &o, &error));
    assert_string_equal(error, "the figures of node 1 do not add up to its time");
    free(error);
    outcome_clear(&o);
}

static void a_failed_run_is_told(void **state)
{
    (void)state;
    char *error = NULL;
    struct outcome o = measured(), failed = {.error = (char *)"it broke"};
    assert_null(explain_read(&paper, &row, 1, &failed, &o, &error));
    assert_string_equal(error, "it broke");
    free(error);
    outcome_clear(&o);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_accounts_cover_all_time),
        cmocka_unit_test(each_second_is_in_its_line),
        cmocka_unit_test(what_does_not_add_up_is_refused),
        cmocka_unit_test(a_failed_run_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
