/* test_speedup.c - speed-ups are against one baseline: the best point of the fewest nodes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "lab/chart/speedup.h"
#include "lab/jobs/outcome.h"

/* Groups of 2 are the fastest, and groups of 8 the slowest, which no run on less than 8 nodes has. */
static const char RESULTS[] =
    "{ \"title\": \"T\", \"axes\": { \"nodes\": [8, 2], \"group\": [8, 2], \"image\": [\"a\", \"b\"] },"
    "  \"points\": ["
    "  { \"nodes\": 8, \"group\": 8, \"image\": \"a\", \"time_s\": 40 },"
    "  { \"nodes\": 8, \"group\": 2, \"image\": \"a\", \"time_s\": 10 },"
    "  { \"nodes\": 2, \"group\": 2, \"image\": \"a\", \"time_s\": 64 },"
    "  { \"nodes\": 8, \"group\": 8, \"image\": \"b\", \"time_s\": 50 },"
    "  { \"nodes\": 8, \"group\": 2, \"image\": \"b\", \"time_s\": 20 },"
    "  { \"nodes\": 2, \"group\": 2, \"image\": \"b\", \"time_s\": 32 },"
    "  { \"nodes\": 2, \"group\": 8, \"image\": \"b\", \"failure\": \"crashed\" } ] }";

static void is(double value, double wanted)
{
    if (!(fabs(value - wanted) <= 1e-12 * wanted))
        fail_msg("%.15g is not %.15g", value, wanted);
}

static bool each(void *arg, bool (*visit)(void *, const json_t *, char **), void *to, char **error)
{
    size_t i;
    json_t *point;
    json_array_foreach((json_t *)arg, i, point) if (!visit(to, point, error)) return false;
    return true;
}

static struct record_points results(void)
{
    json_t *root = json_loads(RESULTS, 0, NULL);
    assert_non_null(root);
    return (struct record_points){each, json_object_get(root, "points"), root};
}

static double figure(const struct record_points *r, size_t i, const char *key)
{
    return figure_of(json_array_get(json_object_get(r->header, "points"), i), key);
}

/* Each line's own baseline gave the slowest group the speed-up 8 on 8 nodes. */
static void one_baseline_for_all(void **state)
{
    (void)state;
    char *error = NULL;
    struct record_points r = results();
    assert_true(speedup_renew(&r, NULL, &error));
    assert_string_equal(json_string_value(json_object_get(r.header, "baseline")),
                        "nodes 2, group 2, image b, assumed ideal");
    static const double speedup[] = {1.6, 6.4, 1, 1.28, 3.2, 2};
    for (size_t i = 0; i < 6; i++) {
        is(figure(&r, i, "speedup"), speedup[i]);
        is(figure(&r, i, "speed_per_node") * figure(&r, i, "nodes"), speedup[i]);
    }
    assert_true(figure(&r, 0, "speedup") < figure(&r, 1, "speedup"));
    assert_null(json_object_get(json_array_get(json_object_get(r.header, "points"), 6), "speedup"));
    record_free(&r);
}

static void a_baseline_for_each_value(void **state)
{
    (void)state;
    char *error = NULL;
    struct record_points r = results();
    assert_true(speedup_renew(&r, (const char *const[]){"image", NULL}, &error));
    assert_string_equal(json_string_value(json_object_get(r.header, "baseline")),
                        "the fewest nodes of each image, assumed ideal");
    static const double speedup[] = {3.2, 12.8, 2, 1.28, 3.2, 2};
    for (size_t i = 0; i < 6; i++)
        is(figure(&r, i, "speedup"), speedup[i]);
    record_free(&r);
}

static void a_baseline_of_a_value(void **state)
{
    (void)state;
    char *error = NULL;
    struct record_points r = results();
    assert_true(speedup_renew(&r, (const char *const[]){"group=8", "image=b", NULL}, &error));
    assert_string_equal(json_string_value(json_object_get(r.header, "baseline")),
                        "nodes 8, group 8, image b, assumed ideal");
    is(figure(&r, 3, "speedup"), 8);
    is(figure(&r, 1, "speedup"), 40);
    record_free(&r);
}

/* The baseline was ", assumed ideal". */
static void one_point_has_no_baseline(void **state)
{
    (void)state;
    char *error = NULL;
    json_t *root = json_loads(
        "{ \"axes\": { \"nodes\": [4] }, \"points\": [ { \"nodes\": 4, \"time_s\": 8 } ] }", 0, NULL);
    struct record_points r = {each, json_object_get(root, "points"), root};
    assert_true(speedup_renew(&r, NULL, &error));
    const char *baseline = json_string_value(json_object_get(r.header, "baseline"));
    assert_true(!baseline || !*baseline);
    record_free(&r);
}

/* What a program prints under these names is its own affair, unless the user asks for a baseline. */
static void a_programs_own_figure_stays(void **state)
{
    (void)state;
    char *error = NULL;
    struct record_points r = results();
    struct speedup *s = speedup_find(&r, NULL, &error);
    json_t *point = json_pack("{s:i, s:i, s:s, s:f, s:i}", "nodes", 8, "group", 2, "image", "a", "time_s",
                              10.0, "speedup", 3);
    speedup_add(s, point, false);
    is(figure_of(point, "speedup"), 3);
    is(figure_of(point, "speed_per_node"), 0.8);
    speedup_add(s, point, true);
    is(figure_of(point, "speedup"), 6.4);
    json_decref(point);
    speedup_free(s);
    record_free(&r);
}

static void mistakes_are_named(void **state)
{
    static const char *const wrong[][2] = {
        {"grop",
         "baseline \"grop\": there is no axis grop; did you mean group? There are: nodes, group, image"},
        {"group=4", "baseline \"group=4\": axis group has no value 4"},
    };
    (void)state;
    for (size_t i = 0; i < 2; i++) {
        char *error = NULL;
        struct record_points r = results();
        assert_false(speedup_renew(&r, (const char *const[]){wrong[i][0], NULL}, &error));
        assert_string_equal(error, wrong[i][1]);
        free(error);
        record_free(&r);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_baseline_for_all),        cmocka_unit_test(a_baseline_for_each_value),
        cmocka_unit_test(one_point_has_no_baseline),   cmocka_unit_test(a_baseline_of_a_value),
        cmocka_unit_test(a_programs_own_figure_stays), cmocka_unit_test(mistakes_are_named)};
    return cmocka_run_group_tests_name("speedup", tests, NULL, NULL);
}
