/* Routes: e-cube on the hypercube, along the row and then the column on the mesh; ports first and last. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>
#include "net/topo.h"

/* The nodes a route passes, from the numbers of its link channels. */
static int nodes_passed(const struct topo *t, uint32_t from, uint32_t to, uint32_t *nodes)
{
    struct topo_walk w;
    uint32_t channel, links = t->rows ? 4 : t->dimension, ports = t->positions * links;
    int count = 0, steps = 0;
    topo_begin(t, &w, from, to);
    while (topo_step(t, &w, &channel)) {
        assert_true(channel < t->channels);
        if (channel < ports)
            nodes[count++] = channel % t->positions;
        else
            assert_int_equal(channel, steps == 0 ? ports + from : ports + t->positions + to);
        steps++;
    }
    assert_int_equal(steps, count + 2);
    nodes[count++] = to;
    return count;
}

static void ecube_goes_from_the_lowest_differing_bit(void **state)
{
    struct topo t;
    uint32_t nodes[16];
    const uint32_t expected[] = {0x2, 0x3, 0x1, 0x5};
    (void)state;
    assert_true(topo_hypercube(&t, 16, 7));
    assert_int_equal(t.dimension, 4);
    assert_int_equal(nodes_passed(&t, 0x2, 0x5, nodes), 4);
    for (int i = 0; i < 4; i++)
        assert_int_equal(nodes[i], expected[i]);
}

static void mesh_goes_along_the_row_then_the_column(void **state)
{
    struct topo t;
    uint32_t nodes[16];
    const uint32_t expected[] = {1, 2, 3, 7, 11};
    (void)state;
    assert_true(topo_mesh(&t, 16, 16, 33));
    assert_int_equal(t.rows, 4);
    assert_int_equal(t.columns, 4);
    assert_int_equal(nodes_passed(&t, 1, 11, nodes), 5);
    for (int i = 0; i < 5; i++)
        assert_int_equal(nodes[i], expected[i]);
}

static void every_route_has_as_many_links_as_hops(void **state)
{
    struct topo shapes[3];
    uint32_t nodes[64];
    (void)state;
    assert_true(topo_hypercube(&shapes[0], 32, 7));
    assert_true(topo_mesh(&shapes[1], 32, 16, 33));
    assert_true(topo_mesh(&shapes[2], 33, 16, 33));
    for (int s = 0; s < 3; s++)
        for (uint32_t a = 0; a < 32; a++)
            for (uint32_t b = 0; b < 32; b++)
                assert_int_equal(nodes_passed(&shapes[s], a, b, nodes), topo_hops(&shapes[s], a, b) + 1);
}

static void no_two_channels_share_a_number(void **state)
{
    struct topo t;
    struct topo_walk w;
    uint32_t channel, owner[16 * 6] = {0};
    (void)state;
    assert_true(topo_hypercube(&t, 16, 4));
    assert_int_equal(t.channels, 16 * 6);
    for (uint32_t a = 0; a < 16; a++)
        for (uint32_t bit = 0; bit < 4; bit++) {
            topo_begin(&t, &w, a, a ^ 1u << bit);
            for (int step = 0; topo_step(&t, &w, &channel); step++)
                if (step == 1)
                    assert_int_equal(owner[channel]++, 0);
        }
}

static void machines_that_are_too_small_say_no(void **state)
{
    struct topo t;
    (void)state;
    assert_false(topo_hypercube(&t, 129, 7));
    assert_false(topo_hypercube(&t, 0, 7));
    assert_true(topo_hypercube(&t, 3, 7));
    assert_int_equal(t.positions, 4);
    assert_false(topo_mesh(&t, 16 * 33 + 1, 16, 33));
    assert_false(topo_mesh(&t, 0, 16, 33));
    assert_false(topo_mesh(&t, UINT32_MAX, 16, 33));
    assert_true(topo_mesh(&t, 16 * 33, 16, 33));
    assert_true(
        topo_mesh(&t, 37, 16, 33)); /* prime and too long for a row: the least rectangle that holds it */
    assert_true(t.positions >= 37 && t.positions <= 38);
}

/* --- services --- */

/* The channels of a route; how many. */
static int channels_of(const struct topo *t, uint32_t from, uint32_t to, uint32_t *channels)
{
    struct topo_walk w;
    int n = 0;
    topo_begin(t, &w, from, to);
    while (topo_step(t, &w, &channels[n])) {
        assert_in_range(channels[n], 0, t->channels - 1);
        n++;
    }
    return n;
}

static void services_leave_the_nodes_routes_as_they_are(void **state)
{
    struct topo plain[2], with[2];
    uint32_t a[64], b[64];
    (void)state;
    assert_true(topo_hypercube(&plain[0], 16, 7));
    assert_true(topo_mesh(&plain[1], 16, 16, 33));
    for (int s = 0; s < 2; s++) {
        with[s] = plain[s];
        topo_add_services(&with[s], 11);
        assert_int_equal(with[s].addresses, 16 + 11);
        for (uint32_t i = 0; i < 256; i++) {
            int n = channels_of(&plain[s], i / 16, i % 16, a);
            assert_int_equal(channels_of(&with[s], i / 16, i % 16, b), n);
            assert_memory_equal(a, b, (size_t)n * sizeof *a);
        }
    }
}

static void services_of_a_mesh_are_columns_at_its_edge(void **state)
{
    struct topo t;
    (void)state;
    assert_true(topo_mesh(&t, 9, 16, 33));
    topo_add_services(&t, 5);
    assert_int_equal(topo_hops(&t, 2, 9), 1);  /* the first row's */
    assert_int_equal(topo_hops(&t, 5, 10), 1); /* the second's */
    assert_int_equal(topo_hops(&t, 2, 12), 2); /* the first row's second */
    assert_int_equal(topo_hops(&t, 6, 12), 6);
    assert_int_equal(topo_hops(&t, 13, 11), 2);
}

static void services_of_a_hypercube_hang_on_nodes_spread_evenly(void **state)
{
    struct topo t;
    uint32_t c[16], used[128] = {0};
    (void)state;
    assert_true(topo_hypercube(&t, 128, 7));
    topo_add_services(&t, 10);
    for (uint32_t i = 0; i < 10; i++) {
        uint32_t host = i * 128 / 10;
        assert_int_equal(used[host]++, 0);
        assert_int_equal(topo_hops(&t, host, 128 + i), 1);
        assert_int_equal(channels_of(&t, host, 128 + i, c), 2); /* the node's port, the service's channel */
        assert_int_equal(topo_hops(&t, host ^ 127, 128 + i), 8);
    }
}

/* The order of channels of which each route takes some, one after the other, has no cycle: Kahn's algorithm
 * takes away channels that no other comes before, until none is left. */
static void no_cycle(const struct topo *t)
{
    uint32_t n = t->channels, *before = calloc(n, sizeof *before), left = n, c[128];
    char *follows = calloc((size_t)n * n, 1), *gone = calloc(n, 1);
    for (uint32_t a = 0; a < t->addresses; a++)
        for (uint32_t b = 0; b < t->addresses; b++)
            for (int i = 1, m = channels_of(t, a, b, c); i < m; i++)
                if (!follows[(size_t)c[i - 1] * n + c[i]]) {
                    follows[(size_t)c[i - 1] * n + c[i]] = 1;
                    before[c[i]]++;
                }
    for (uint32_t last = n + 1; left < last;) {
        last = left;
        for (uint32_t i = 0; i < n; i++) {
            if (gone[i] || before[i] > 0)
                continue;
            gone[i] = 1, left--;
            for (uint32_t k = 0; k < n; k++)
                before[k] -= follows[(size_t)i * n + k];
        }
    }
    assert_int_equal(left, 0);
    free(before);
    free(follows);
    free(gone);
}

static void routes_with_services_have_no_cycle(void **state)
{
    static const uint32_t sizes[] = {1, 2, 7, 16, 24};
    (void)state;
    for (int i = 0; i < 5; i++) {
        struct topo cube, mesh;
        assert_true(topo_hypercube(&cube, sizes[i], 7));
        assert_true(topo_mesh(&mesh, sizes[i], 16, 33));
        topo_add_services(&cube, 11);
        topo_add_services(&mesh, 11);
        no_cycle(&cube);
        no_cycle(&mesh);
    }
}

static void every_route_ends_where_it_should(void **state)
{
    struct topo t;
    uint32_t c[128];
    (void)state;
    for (int mesh = 0; mesh < 2; mesh++) {
        assert_true(mesh ? topo_mesh(&t, 13, 16, 33) : topo_hypercube(&t, 13, 7));
        topo_add_services(&t, 33);
        for (uint32_t a = 0; a < t.addresses; a++)
            for (uint32_t b = 0; b < t.addresses; b++) {
                uint32_t ends = mesh ? 2 : 2 - (a >= t.positions) - (b >= t.positions);
                assert_int_equal(channels_of(&t, a, b, c), topo_hops(&t, a, b) + ends);
            }
    }
}

static void the_host_hangs_on_node_0(void **state)
{
    struct topo t;
    struct topo_walk w;
    uint32_t channel, count[2] = {0, 0}, own[2][8];
    (void)state;
    assert_true(topo_hypercube(&t, 8, 7));
    topo_add_services(&t, 3);
    uint32_t before = t.channels;
    topo_add_host(&t);
    assert_int_equal(topo_host(&t), 11);
    assert_true(topo_is_host(&t, 11) && !topo_is_host(&t, 10));
    for (uint32_t i = 0; i < 8; i++) {
        assert_int_equal(topo_hops(&t, topo_host(&t), i), 1 + __builtin_popcount(i));
        assert_int_equal(topo_hops(&t, i, topo_host(&t)), 1 + __builtin_popcount(i));
    }
    for (int way = 0; way < 2; way++)
        for (topo_begin(&t, &w, way ? 5 : 11, way ? 11 : 5); topo_step(&t, &w, &channel);)
            own[way][count[way]++] = channel;
    assert_true(count[0] == 4 && count[1] == 4); /* its own, two of the cube, the port */
    assert_true(own[0][0] >= before && own[1][3] >= before && own[0][0] != own[1][3]);
    assert_true(own[0][0] < t.channels && own[1][3] < t.channels);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ecube_goes_from_the_lowest_differing_bit),
        cmocka_unit_test(mesh_goes_along_the_row_then_the_column),
        cmocka_unit_test(every_route_has_as_many_links_as_hops),
        cmocka_unit_test(no_two_channels_share_a_number),
        cmocka_unit_test(machines_that_are_too_small_say_no),
        cmocka_unit_test(services_leave_the_nodes_routes_as_they_are),
        cmocka_unit_test(services_of_a_mesh_are_columns_at_its_edge),
        cmocka_unit_test(services_of_a_hypercube_hang_on_nodes_spread_evenly),
        cmocka_unit_test(routes_with_services_have_no_cycle),
        cmocka_unit_test(the_host_hangs_on_node_0),
        cmocka_unit_test(every_route_ends_where_it_should),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
