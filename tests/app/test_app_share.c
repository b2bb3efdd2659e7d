/* test_app_share.c - how slices, subcubes and nodes are divided; packing; the command line. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdlib.h>
#include <string.h>
#include "layer.h"
#include "share.h"
#include "volume_mesh.h"

/* A choice: the paper says "its share of slices" and no more; Table 3 has one group with a layer more. */
static void the_first_group_gets_the_extra_slice(void **state)
{
    (void)state;
    static const struct {
        int groups, first, others, last;
    } want[] = {{1, 64, 64, 64}, {2, 33, 31, 31}, {4, 17, 16, 15},
                {8, 9, 8, 7},    {16, 5, 4, 3},   {32, 3, 2, 1}};
    for (size_t i = 0; i < sizeof want / sizeof *want; i++) {
        int groups = want[i].groups;
        assert_int_equal(share_layers(65, 64, groups, 0).layers, want[i].first);
        assert_int_equal(share_layers(65, 64, groups, groups - 1).layers, want[i].last);
        for (int g = 1; g < groups - 1; g++)
            assert_int_equal(share_layers(65, 64, groups, g).layers, want[i].others);
    }
}

static void the_groups_layers_follow_each_other_without_a_gap(void **state)
{
    (void)state;
    for (int slices = 2; slices < 70; slices++)
        for (int groups = 1; groups < 80; groups++) {
            int next = 0;
            for (int g = 0; g < groups; g++) {
                struct span s = share_layers(slices, slices - 1, groups, g);
                assert_true(s.layers >= 0);
                if (s.layers > 0)
                    assert_int_equal(s.first, next);
                next += s.layers;
            }
            assert_int_equal(next, slices - 1);
        }
}

static void layers_can_be_dealt_evenly(void **state)
{
    (void)state;
    for (int g = 0; g < 8; g++)
        assert_int_equal(share_layers(64, 64, 8, g).layers, 8);
    assert_int_equal(share_layers(64, 64, 8, 7).first, 56);
}

static void chunks_are_whole_rows_and_sum_to_the_layer(void **state)
{
    (void)state;
    for (int nodes = 2; nodes <= 128; nodes++) {
        struct pool p;
        int sum = 0, first, n, last = 128 * 128;
        pool_fill(&p, 128, 128);
        while ((n = pool_chunk(&p, 1.6, nodes, 1, &first)) > 0) {
            assert_int_equal(first, sum);
            assert_int_equal(n % 128, 0);
            assert_true(n <= last); /* they only get smaller */
            last = n;
            sum += n;
        }
        assert_int_equal(sum, 128 * 128);
        assert_int_equal(last, 128);
    }
}

/* That a first chunk is a kth of a share is a choice, and k was fitted. */
static void the_first_chunk_is_a_kth_of_an_even_share(void **state)
{
    (void)state;
    struct pool p;
    int first;
    pool_fill(&p, 128, 128);
    assert_int_equal(pool_chunk(&p, 1.6, 16, 1, &first), 5 * 128);
    assert_int_equal(pool_chunk(&p, 1.6, 16, 7, &first), 7 * 128);
}

static void a_least_number_of_rows_beyond_the_layer_takes_what_is_left(void **state)
{
    (void)state;
    struct pool p;
    int first;
    pool_fill(&p, 128, 128);
    pool_help(&p, 5, 0, &first);
    assert_int_equal(pool_chunk(&p, 1.6, 16, 1000000000, &first), 128 * 128 - 5);
    assert_int_equal(pool_left(&p), 0);
}

static void no_chunk_is_greater_than_the_greatest(void **state)
{
    (void)state;
    static const double ks[] = {0.3, 1, 1.6, 7};
    for (int k = 0; k < 4; k++)
        for (int nodes = 2; nodes < 20; nodes++)
            for (int min_rows = 1; min_rows < 300; min_rows += 37) {
                struct pool p;
                int first, n, most = pool_chunk_max(131, 47, ks[k], min_rows);
                pool_fill(&p, 131, 47);
                assert_true(most <= 131 * 47);
                while ((n = pool_chunk(&p, ks[k], nodes, min_rows, &first)) > 0)
                    assert_true(n <= most);
            }
    assert_true(pool_chunk_max(131, 47, 1.6, 1) < 131 * 47 / 3 + 47);
}

static void the_host_helps_from_the_end_and_leaves_its_slaves_some(void **state)
{
    (void)state;
    struct pool p;
    int first;
    pool_fill(&p, 10, 20);
    assert_int_equal(pool_help(&p, 16, 150, &first), 16);
    assert_int_equal(first, 184);
    assert_int_equal(pool_help(&p, 100, 150, &first), 34);
    assert_int_equal(pool_help(&p, 100, 150, &first), 0);
    assert_int_equal(pool_left(&p), 150);
    assert_int_equal(pool_chunk(&p, 0.5, 1, 8, &first), 150); /* the last row is not whole any more */
    assert_int_equal(pool_left(&p), 0);
}

static void nodes_are_dealt_by_largest_remainder(void **state)
{
    (void)state;
    static const double weight[] = {2, 0, 1, 1, 0.2};
    static const int want[] = {4, 0, 2, 2, 0};
    int got[5];
    share_nodes(8, 5, weight, got);
    assert_memory_equal(got, want, sizeof want);

    static const double many[] = {2, 1, 1, 1, 1};
    static const int first_served[] = {1, 1, 0, 0, 0};
    share_nodes(2, 5, many, got);
    assert_memory_equal(got, first_served, sizeof first_served);

    static const double none[] = {0, 0};
    share_nodes(3, 2, none, got);
    assert_int_equal(got[0] + got[1], 0);
}

static void all_nodes_are_dealt(void **state)
{
    (void)state;
    unsigned seed = 5;
    for (int i = 0; i < 1000; i++) {
        double weight[32];
        int got[32], n = 1 + rand_r(&seed) % 40, sum = 0;
        for (int g = 0; g < 32; g++)
            weight[g] = rand_r(&seed) % 3 ? 0 : rand_r(&seed) % 1000 / 100.0;
        weight[7] = 0.5;
        share_nodes(n, 32, weight, got);
        for (int g = 0; g < 32; g++) {
            assert_true(got[g] >= 0 && (weight[g] > 0 || got[g] == 0));
            sum += got[g];
        }
        assert_int_equal(sum, n);
    }
}

/* --- a chunk's subcubes give the same polygons as the layer's --- */

static double sum, polygons;

static void add_up(int iso, int n, const vertex *v)
{
    for (int i = 0; i < n; i++)
        for (int d = 0; d < 6; d++)
            sum += (iso + 1) * (i + 1) * v[i][d];
    polygons++;
}

static void a_packed_chunk_is_as_good_as_the_layer(void **state)
{
    (void)state;
    static const char *const lines[] = {"-minrows 5 -sphere 50 41 5",
                                        "-minrows 5 -approx 333 -sphere 50 41 5"};
    for (int i = 0; i < 2; i++) {
        struct options o = options_of(lines[i]);
        pixel *p = volume_sphere(&o.grid);
        double *data = volume_data(&o.grid, p), *message = malloc((size_t)chunk_bytes_max(&o));
        struct layer l = {.lower = data, .upper = data + grid_slice_doubles(&o.grid)};
        struct fit_system system = {0};
        int first = 3 * o.grid.nx, count = 4 * o.grid.nx + 5;
        double direct, number;
        sum = polygons = 0;
        layer_prepare(&o, &system, 0);
        for (int c = 0; c < count; c++)
            layer_cell(&o, &system, &l, first + c, add_up);
        direct = sum;
        number = polygons;
        assert_true(chunk_pack(&o.grid, &l, first, count, message) <= chunk_bytes_max(&o));
        struct chunk c = chunk_unpack(&o.grid, message);
        assert_int_equal(c.kind, CHUNK_WORK);
        assert_int_equal(c.first, first);
        assert_int_equal(c.count, count);
        sum = polygons = 0;
        for (int k = 0; k < c.count; k++)
            layer_cell(&o, &system, &c.layer, c.first + k, add_up);
        assert_true(polygons == number && polygons > 0);
        assert_true(sum == direct); /* to the bit */
        free(message);
        free(data);
        free(p);
    }
}

/* --- the command line --- */

static void check_refused(const char *option, const char *value, const char *words)
{
    char error[256], *argv[] = {"model", (char *)option, (char *)value};
    struct options o;
    assert_int_equal(options_read(&o, value ? 3 : 2, argv, error, sizeof error), -1);
    assert_non_null(strstr(error, option));
    assert_non_null(strstr(error, words));
}

static void wrong_options_are_named(void **state)
{
    (void)state;
    check_refused("-nodes", NULL, "no such option");
    check_refused("-keep", NULL, "needs a number");
    check_refused("-keep", "many", "'many'");
    check_refused("-gran", "0", "from 1 up");
    check_refused("-k", "-1", "above 0");
    check_refused("-approx", "222", "111 333");
    check_refused("-isovalues", "1,,2", "commas");
    check_refused("-isovalues", "1,nan", "commas");
    check_refused("-isovalues", "-inf", "commas");
    check_refused("-zspace", "inf", "above 0");
    check_refused("-k", "nan", "above 0");
    check_refused("-lattice", "5", "at most 4");
}

static void defaults_are_the_papers_volumes(void **state)
{
    (void)state;
    struct options o = options_of(""), c = options_of("-approx 333"),
                   f = options_of("-volume x 9 8 7 8 -group 4 -k 2.5");
    assert_int_equal(o.grid.pixels_x, 512);
    assert_int_equal(o.grid.slices, 65);
    assert_int_equal(o.iso.n, 7);
    assert_int_equal(c.grid.pixels_x, 192);
    assert_int_equal(c.grid.pixels_y, 128);
    assert_int_equal(c.grid.comps, 8);
    assert_string_equal(f.volume, "x");
    assert_int_equal(f.bits, 8);
    assert_int_equal(f.policy.group, 4);
    assert_true(f.policy.k == 2.5);
    assert_true(f.iso.value[3] > 128 && f.iso.value[3] < 128.01);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_first_group_gets_the_extra_slice),
        cmocka_unit_test(the_groups_layers_follow_each_other_without_a_gap),
        cmocka_unit_test(layers_can_be_dealt_evenly),
        cmocka_unit_test(chunks_are_whole_rows_and_sum_to_the_layer),
        cmocka_unit_test(the_first_chunk_is_a_kth_of_an_even_share),
        cmocka_unit_test(a_least_number_of_rows_beyond_the_layer_takes_what_is_left),
        cmocka_unit_test(no_chunk_is_greater_than_the_greatest),
        cmocka_unit_test(the_host_helps_from_the_end_and_leaves_its_slaves_some),
        cmocka_unit_test(nodes_are_dealt_by_largest_remainder),
        cmocka_unit_test(all_nodes_are_dealt),
        cmocka_unit_test(a_packed_chunk_is_as_good_as_the_layer),
        cmocka_unit_test(wrong_options_are_named),
        cmocka_unit_test(defaults_are_the_papers_volumes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
