/* Sharing out nodes: buddies on a hypercube, rectangles on a mesh, at most ten cubes, who is told what. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "srm/cubes.h"
#include "srm/job.h"

static const struct cfg_machine CUBE = {
    .name = "cube", .topology = CFG_HYPERCUBE, .dimension = 5, .memory_bytes = 16 << 20};
static const struct cfg_machine MESH = {
    .name = "mesh", .topology = CFG_MESH, .rows = 4, .columns = 6, .memory_bytes = 16 << 20};

/* The first node of what `holder` gets, or -1. */
static int take(struct allocation *s, uint32_t nodes, uint8_t holder)
{
    struct allocation_piece p;
    if (!allocation_take(s, &(struct cube_type){.nodes = nodes}, holder, &p))
        return -1;
    assert_int_equal(p.nodes, nodes);
    return (int)(p.row * s->columns + p.column);
}

static void cubes_are_aligned_and_do_not_overlap(void **state)
{
    struct allocation s;
    (void)state;
    allocation_open(&s, &CUBE);
    srand(1);
    bool held[256] = {0};
    for (int i = 0; i < 2000; i++) {
        uint8_t holder = (uint8_t)(1 + rand() % 20);
        uint32_t nodes = UINT32_C(1) << rand() % 6, before = allocation_free(&s);
        struct allocation_piece p;
        if (held[holder]) {
            allocation_give_back(&s, holder);
            held[holder] = false;
            assert_true(allocation_free(&s) > before);
        } else if (allocation_take(&s, &(struct cube_type){.nodes = nodes}, holder, &p)) {
            held[holder] = true;
            assert_int_equal(p.column % nodes, 0);
            assert_int_equal(before - allocation_free(&s), nodes); /* all of it was free */
            for (uint32_t k = 0; k < nodes; k++)
                assert_int_equal(s.holder[p.column + k], holder);
        } else {
            assert_true(allocation_largest(&s) < nodes); /* refused only if there is none */
        }
    }
    allocation_close(&s);
}

static void the_smallest_hole_is_taken(void **state)
{
    struct allocation s;
    (void)state;
    allocation_open(&s, &CUBE);
    assert_int_equal(take(&s, 16, 1), 0);
    assert_int_equal(take(&s, 4, 2), 16);
    assert_int_equal(take(&s, 8, 3), 24); /* 16 to 23 is broken into */
    allocation_give_back(&s, 1);
    assert_int_equal(take(&s, 4, 4), 20); /* not from the 16 that are whole */
    assert_int_equal(take(&s, 16, 5), 0);
    allocation_close(&s);
}

static void nodes_that_are_free_but_apart_are_no_cube(void **state)
{
    struct allocation s;
    (void)state;
    allocation_open(&s, &CUBE);
    for (uint8_t i = 0; i < 8; i++)
        assert_int_equal(take(&s, 4, (uint8_t)(i + 1)), 4 * i);
    for (uint8_t i = 0; i < 8; i += 2)
        allocation_give_back(&s, (uint8_t)(i + 1));
    assert_int_equal(allocation_free(&s), 16);
    assert_int_equal(allocation_largest(&s), 4);
    assert_int_equal(take(&s, 8, 20), -1);
    allocation_give_back(&s, 2); /* buddies are one again */
    assert_int_equal(allocation_largest(&s), 8);
    assert_int_equal(take(&s, 8, 20), 0);
    allocation_close(&s);
}

static void a_mesh_gives_rectangles_first_fit(void **state)
{
    struct allocation s;
    struct allocation_piece p;
    (void)state;
    allocation_open(&s, &MESH);
    assert_true(allocation_take(&s, &(struct cube_type){6, 2, 3}, 1, &p));
    assert_true(p.row == 0 && p.column == 0 && p.rows == 2 && p.columns == 3);
    assert_true(
        allocation_take(&s, &(struct cube_type){.nodes = 4}, 2, &p)); /* 2 x 2, as touchstone run -n 4 */
    assert_true(p.row == 0 && p.column == 3 && p.rows == 2 && p.columns == 2);
    assert_true(allocation_take(&s, &(struct cube_type){8, 4, 2}, 3, &p) ==
                false); /* one column of 4 is left */
    assert_true(allocation_take(&s, &(struct cube_type){6, 2, 3}, 3, &p));
    assert_true(p.row == 2 && p.column == 0);
    assert_int_equal(allocation_free(&s), 24 - 16);
    assert_int_equal(allocation_largest(&s), 6); /* rows 2 and 3, columns 3 to 5 */
    assert_true(allocation_possible(&s, &(struct cube_type){24, 4, 6}));
    assert_false(allocation_possible(&s, &(struct cube_type){24, 6, 4}));
    allocation_close(&s);
}

static struct cube_entry *get(struct cubes *c, const char *name, const char *type, char **error)
{
    return cubes_get(c, name, type, "ann", "1", error);
}

static void refused(struct cubes *c, const char *name, const char *type, const char *says)
{
    char *error = NULL;
    assert_null(get(c, name, type, &error));
    if (!strstr(error, says))
        fail_msg("\"%s\" does not say \"%s\"", error, says);
    free(error);
}

static void there_are_ten_cubes_at_most(void **state)
{
    struct cubes c;
    char *error, name[16];
    (void)state;
    cubes_open(&c, &CUBE);
    for (int i = 0; i < 10; i++) {
        snprintf(name, sizeof name, "c%d", i);
        assert_non_null(get(&c, name, "2", &error));
    }
    refused(&c, "c10", "2", "10 cubes");
    cubes_release(&c, cubes_find(&c, "c3", "1", &error));
    assert_non_null(get(&c, "c10", "2", &error));
    cubes_close(&c);
}

static void errors_say_who_holds_what(void **state)
{
    struct cubes c;
    char *error;
    (void)state;
    cubes_open(&c, &CUBE);
    assert_non_null(get(&c, "a", "d4", &error));
    assert_non_null(get(&c, "b", "8m16", &error));
    refused(&c, "x", "16", "16 nodes are asked for; 8 of 32 are free, the largest cube of them 8:");
    refused(&c, "x", "16", "a of ann holds nodes 0 to 15");
    refused(&c, "x", "16", "b of ann holds nodes 16 to 23");
    refused(&c, "a", "1", "there is a cube \"a\" already");
    refused(&c, "x", "33", "a cube of 64 nodes does not fit in cube, a hypercube of ");
    refused(&c, "x", "4m32", "have 16 MB");
    refused(&c, "x", "0", "begins with a number of nodes");
    refused(&c, "x", "d31", "begins with a number of nodes");
    refused(&c, "x", "2x4", "for a mesh");
    refused(&c, "a b", "2", "no blanks");
    refused(&c, "", "2", "1 to 31 characters");
    cubes_close(&c);
}

static void a_terminal_works_with_the_cube_it_got_last(void **state)
{
    struct cubes c;
    char *error;
    (void)state;
    cubes_open(&c, &CUBE);
    assert_null(cubes_find(&c, "", "1", &error));
    free(error);
    struct cube_entry *a = cubes_get(&c, "a", "2", "ann", "1", &error);
    assert_ptr_equal(cubes_find(&c, "", "2", &error), a); /* the only one */
    struct cube_entry *b = cubes_get(&c, "b", "2", "ann", "1", &error);
    assert_ptr_equal(cubes_find(&c, "", "1", &error), b);
    assert_ptr_equal(cubes_find(&c, "a", "1", &error), a);
    assert_null(cubes_find(&c, "", "2", &error)); /* which? */
    free(error);
    cubes_attach(&c, a, "1");
    assert_ptr_equal(cubes_find(&c, "", "1", &error), a);
    cubes_release(&c, a);
    assert_ptr_equal(cubes_find(&c, "", "1", &error), b); /* the only one */
    assert_null(cubes_find(&c, "a", "1", &error));
    free(error);
    cubes_close(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cubes_are_aligned_and_do_not_overlap),
        cmocka_unit_test(the_smallest_hole_is_taken),
        cmocka_unit_test(nodes_that_are_free_but_apart_are_no_cube),
        cmocka_unit_test(a_mesh_gives_rectangles_first_fit),
        cmocka_unit_test(there_are_ten_cubes_at_most),
        cmocka_unit_test(errors_say_who_holds_what),
        cmocka_unit_test(a_terminal_works_with_the_cube_it_got_last),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
