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
    topo_begin(&w, from, to);
    while (topo_step(t, &w, &channel)) {
        assert_true(channel < t->channels);
        if (channel < ports)
            nodes[count++] = channel / links;
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
            topo_begin(&w, a, a ^ 1u << bit);
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
    assert_true(topo_mesh(&t, 16 * 33, 16, 33));
    assert_true(
        topo_mesh(&t, 37, 16, 33)); /* prime and too long for a row: the least rectangle that holds it */
    assert_true(t.positions >= 37 && t.positions <= 38);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ecube_goes_from_the_lowest_differing_bit),
        cmocka_unit_test(mesh_goes_along_the_row_then_the_column),
        cmocka_unit_test(every_route_has_as_many_links_as_hops),
        cmocka_unit_test(no_two_channels_share_a_number),
        cmocka_unit_test(machines_that_are_too_small_say_no),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
