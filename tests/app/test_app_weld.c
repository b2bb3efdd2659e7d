/* test_app_weld.c - the table of vertices: numbers, means of normals, too little memory. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "little_memory.h"
#include "weld.h"

static void equal_positions_have_one_number(void **state)
{
    (void)state;
    struct weld *w = weld_begin(10);
    part_vertex a = {1, 2, 3, 0, 0, 1}, b = {1, 2, 3, 1, 0, 0}, c = {0.0f, 2, 3, 1}, d = {-0.0f, 2, 3, 1};
    assert_int_equal(weld_add(w, a), 0);
    assert_int_equal(weld_add(w, c), 1);
    assert_int_equal(weld_add(w, b), 0);
    assert_int_equal(weld_add(w, d), 1);
    assert_int_equal(weld_find(w, b), 0);
    c[1] = nextafterf(2, 3);
    assert_int_equal(weld_find(w, c), -1);
    assert_int_equal(weld_next(w), 2);
    weld_end(w);
}

/* Six vertices, of which each has up to nine corners with normals of its own. */
static void mean_normals(unsigned order, part_vertex *mean)
{
    struct weld *w = weld_begin(6);
    unsigned seed = 3;
    part_vertex corner[54];
    for (int i = 0; i < 54; i++) {
        double normal[3];
        corner[i][0] = (float)(i % 6);
        corner[i][1] = corner[i][2] = 0;
        for (int d = 0; d < 3; d++)
            normal[d] = rand_r(&seed) % 2001 - 900.0;
        polygon_normalise(normal);
        for (int d = 0; d < 3; d++)
            corner[i][3 + d] = (float)normal[d];
    }
    for (int i = 0; i < 6; i++)
        weld_add(w, corner[i]);
    for (int i = 53; i >= 6; i--) {
        int j = 6 + rand_r(&order) % (i - 5);
        part_vertex v;
        memcpy(v, corner[j], sizeof v);
        memcpy(corner[j], corner[i], sizeof v);
        weld_normal(w, v);
    }
    for (int i = 0; i < 6; i++)
        assert_true(weld_vertex(w, i, mean[i]));
    assert_false(weld_vertex(w, 6, mean[5]));
    weld_end(w);
}

static void the_mean_normal_does_not_depend_on_the_order(void **state)
{
    (void)state;
    part_vertex first[6], now[6];
    mean_normals(1, first);
    for (unsigned order = 2; order < 200; order++) {
        mean_normals(order, now);
        assert_memory_equal(now, first, sizeof first);
    }
}

static void the_mean_of_two_normals_is_half_way(void **state)
{
    (void)state;
    struct weld *w = weld_begin(1);
    part_vertex a = {5, 5, 5, 1, 0, 0}, b = {5, 5, 5, 0, -1, 0}, mean;
    weld_add(w, a);
    weld_normal(w, b);
    assert_true(weld_vertex(w, 0, mean));
    assert_true(fabs(mean[3] - sqrt(0.5)) < 1e-7 && fabs(mean[4] + sqrt(0.5)) < 1e-7 && mean[5] == 0);
    weld_end(w);
}

static void a_new_layer_keeps_the_vertices_between(void **state)
{
    (void)state;
    struct weld *w = weld_begin(1000);
    part_vertex v = {0};
    for (int i = 0; i < 600; i++) {
        v[0] = (float)i;
        v[2] = i % 3 == 0 ? 8.0f : 7.5f;
        weld_add(w, v);
    }
    weld_forget(w, 8);
    for (int i = 0; i < 600; i++) {
        v[0] = (float)i;
        v[2] = i % 3 == 0 ? 8.0f : 7.5f;
        assert_int_equal(weld_find(w, v), i % 3 == 0 ? i : -1);
    }
    v[2] = 9;
    assert_int_equal(weld_add(w, v), 600);
    assert_true(weld_vertex(w, 0, v));
    assert_true(v[2] == 9);
    assert_false(weld_vertex(w, 1, v));
    weld_end(w);
}

static void what_there_is_no_memory_for_has_no_number(void **state)
{
    (void)state;
    part_vertex v = {0};
    little_memory = 100000;
    struct weld *w = weld_begin(100000);
    long room = weld_room(w), added = 0;
    assert_in_range(room, 1500, 2500);
    for (int i = 0; i < 5000; i++) {
        v[0] = (float)i;
        added += weld_add(w, v) >= 0;
    }
    assert_int_equal(added, room);
    v[0] = 0;
    assert_int_equal(weld_add(w, v), 0);
    weld_end(w);
    little_memory = 100;
    w = weld_begin(100000);
    assert_int_equal(weld_room(w), 0);
    assert_int_equal(weld_add(w, v), -1);
    assert_int_equal(weld_find(w, v), -1);
    weld_normal(w, v);
    weld_forget(w, 0);
    assert_false(weld_vertex(w, 0, v));
    weld_end(w);
    little_memory = SIZE_MAX;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_positions_have_one_number),
        cmocka_unit_test(the_mean_normal_does_not_depend_on_the_order),
        cmocka_unit_test(the_mean_of_two_normals_is_half_way),
        cmocka_unit_test(a_new_layer_keeps_the_vertices_between),
        cmocka_unit_test(what_there_is_no_memory_for_has_no_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
