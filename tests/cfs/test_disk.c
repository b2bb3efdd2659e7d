/* A disk: one access at a time, in order of arrival; its time is that of seek, half a rotation, bytes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>
#include "cfs/disk.h"

static const struct cfg_cfs DISK = {.block_bytes = 1000,
                                    .cylinders = 300,
                                    .cylinder_blocks = 10,
                                    .seek_track_ps = 2000,
                                    .seek_ps = 12000,
                                    .rotation_ps = 500,
                                    .disk_ps_per_byte = 1};
enum { TURN = 500, ROW = 1000, TRACK = 2000, SEEK = 12000 };

struct access {
    struct disk_access a;
    vtime done;
    int order;
    bool unwanted;
    int *count;
};

static bool starts(void *ctx, struct disk_access *a)
{
    (void)a;
    return !((struct access *)ctx)->unwanted;
}

static void done(void *ctx, struct disk_access *a, vtime now)
{
    struct access *x = ctx;
    (void)a;
    x->done = now;
    x->order = (*x->count)++;
}

/* Puts them all in at time 0 and lets the disk work. */
static void serve(struct access *x, int n)
{
    struct evq *q = evq_new();
    struct disk *d = disk_new(&DISK, q, 0);
    int count = 0;
    for (int i = 0; i < n; i++) {
        x[i].count = &count;
        x[i].a.starts = starts, x[i].a.done = done, x[i].a.ctx = &x[i];
        disk_put(d, &x[i].a, 0);
    }
    while (evq_step(q, &(struct instant){0}, &(struct instant){0}))
        ;
    disk_free(d);
    evq_free(q);
}

static void accesses_are_served_in_the_order_they_came(void **state)
{
    struct access x[] = {
        {.a = {.row = 9, .rows = 1}}, {.a = {.row = 0, .rows = 1}}, {.a = {.row = 5, .rows = 1}}};
    (void)state;
    serve(x, 3);
    for (int i = 0; i < 3; i++)
        assert_int_equal(x[i].order, i);
}

static void within_a_cylinder_there_is_no_seek(void **state)
{
    struct access x[] = {
        {.a = {.row = 0, .rows = 3}}, {.a = {.row = 3, .rows = 2}}, {.a = {.row = 0, .rows = 1}}};
    (void)state;
    serve(x, 3);
    assert_int_equal(x[0].done, SEEK + TURN + 3 * ROW);
    assert_int_equal(x[1].done - x[0].done, TURN + 2 * ROW);
    assert_int_equal(x[2].done - x[1].done, TURN + ROW);
}

static void a_seek_grows_with_the_root_of_its_distance_up_to_the_average(void **state)
{
    struct access x[] = {{.a = {.row = 0, .rows = 1}},
                         {.a = {.row = 250, .rows = 1}},   /* 25 cylinders: a quarter of a third of them */
                         {.a = {.row = 1250, .rows = 1}},  /* 100 more: a third */
                         {.a = {.row = 2990, .rows = 1}}}; /* 174 more */
    (void)state;
    serve(x, 4);
    assert_int_equal(x[1].done - x[0].done, TRACK + (SEEK - TRACK) / 2 + TURN + ROW);
    assert_int_equal(x[2].done - x[1].done, SEEK + TURN + ROW);
    assert_int_equal(x[3].done - x[2].done, SEEK + TURN + ROW);
}

static void another_file_is_a_seek_away(void **state)
{
    struct access x[] = {{.a = {.file = 1, .row = 0, .rows = 1}}, {.a = {.file = 2, .row = 0, .rows = 1}}};
    (void)state;
    serve(x, 2);
    assert_int_equal(x[1].done - x[0].done, SEEK + TURN + ROW);
}

static void an_access_not_wanted_any_more_takes_no_time(void **state)
{
    struct access x[] = {{.a = {.row = 0, .rows = 1}},
                         {.a = {.row = 100, .rows = 1}, .unwanted = true},
                         {.a = {.row = 1, .rows = 1}}};
    (void)state;
    serve(x, 3);
    assert_int_equal(x[1].done, x[0].done);
    assert_int_equal(x[1].a.rows, 0);
    assert_int_equal(x[2].done - x[0].done, TURN + ROW);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(accesses_are_served_in_the_order_they_came),
        cmocka_unit_test(within_a_cylinder_there_is_no_seek),
        cmocka_unit_test(a_seek_grows_with_the_root_of_its_distance_up_to_the_average),
        cmocka_unit_test(another_file_is_a_seek_away),
        cmocka_unit_test(an_access_not_wanted_any_more_takes_no_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
