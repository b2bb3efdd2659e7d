/* test_deadlock.c - wait-for graphs as people see them: nodes that share a box, edges between boxes. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "lab/deadlock/deadlock_draw.h"
#include "lab/deadlock/deadlock_graph.h"
#include "lab/deadlock/deadlock_layout.h"
#include "lab/deadlock/deadlock_read.h"

static void wait_for(struct waitfor *w, uint32_t node, long type, long from)
{
    struct waitfor_node *n = &w->nodes[node];
    n->state = WAITFOR_WAITS, n->what = WAITFOR_MESSAGE;
    n->call = from < 0 ? "crecv" : "crecvx", n->has_type = true, n->type = type;
    n->select = (struct waitfor_select){type, from, WAITFOR_ANY};
    n->line = "ring.c:7";
}

/* Each waits for the one before it; not analysed. */
static struct waitfor *ring_as_it_is(uint32_t count)
{
    struct waitfor *w = waitfor_new(count);
    for (uint32_t i = 0; i < count; i++)
        wait_for(w, i, 7, (i + count - 1) % count);
    return w;
}

static struct waitfor *ring(uint32_t count)
{
    struct waitfor *w = ring_as_it_is(count);
    waitfor_analyse(w);
    return w;
}

static void test_small_cycle(void **state)
{
    (void)state;
    struct waitfor *w = ring(4);
    struct deadlock_graph *g = deadlock_graph_make(w);
    assert_int_equal(g->count, 4);
    assert_int_equal(g->cycle_count, 4);
    assert_int_equal(g->edge_count, 4);
    for (uint32_t i = 0; i < 4; i++) {
        assert_true(g->edges[i].in_cycle);
        assert_int_equal(g->edges[i].to, (g->edges[i].from + 1) % 4);
        assert_int_equal(w->nodes[g->boxes[g->edges[i].from].nodes[0]].whom,
                         g->boxes[g->edges[i].to].nodes[0]);
    }
    deadlock_graph_free(g);
    waitfor_free(w);
}

/* A long cycle: its first and last nodes, and one box for those between. */
static void test_long_cycle(void **state)
{
    (void)state;
    for (uint32_t count = DEADLOCK_MOST_CYCLE; count <= 512; count += count < 20 ? 1 : 123) {
        struct waitfor *w = ring(count);
        struct deadlock_graph *g = deadlock_graph_make(w);
        uint32_t nodes = 0, several = 0;
        for (uint32_t k = 0; k < g->count; k++)
            nodes += g->boxes[k].count, several += g->boxes[k].count > 1;
        assert_int_equal(nodes, count);
        assert_in_range(g->count, 8, DEADLOCK_MOST_CYCLE);
        assert_int_equal(several, count > DEADLOCK_MOST_CYCLE);
        assert_int_equal(g->edge_count, g->count);
        for (uint32_t i = 0; i < g->edge_count; i++)
            assert_true(g->edges[i].in_cycle && g->edges[i].to == (g->edges[i].from + 1) % g->count);
        deadlock_graph_free(g);
        waitfor_free(w);
    }
}

/* Nodes in one state behind a cycle share a box, whose nodes wait for each other and for the cycle. */
static void test_groups(void **state)
{
    (void)state;
    struct waitfor *all = waitfor_new(100);
    for (uint32_t i = 0; i < 100; i++)
        wait_for(all, i, i < 3 ? 7 : 4, i < 3 ? (i + 1) % 3 : i - 1);
    waitfor_analyse(all);
    struct deadlock_graph *g = deadlock_graph_make(all);
    assert_int_equal(g->count, 4);
    assert_int_equal(g->cycle_count, 3);
    assert_int_equal(g->boxes[3].count, 97);
    assert_int_equal(g->edge_count, 5); /* the cycle's, to itself, and to node 2 */
    assert_int_equal(g->boxes[g->edges[3].to].nodes[0], 2);
    assert_int_equal(g->edges[4].to, 3);
    assert_false(g->edges[3].in_cycle || g->edges[4].in_cycle);
    deadlock_graph_free(g);
    waitfor_free(all);
}

/* Waits that any could end lead to all that live. */
static void test_any(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(4);
    for (uint32_t i = 0; i < 3; i++)
        wait_for(w, i, 7, WAITFOR_ANY);
    w->nodes[3].state = WAITFOR_ENDED;
    waitfor_analyse(w);
    struct deadlock_graph *g = deadlock_graph_make(w);
    assert_int_equal(g->count, 4);
    assert_int_equal(g->edge_count, 6);
    for (uint32_t i = 0; i < 6; i++)
        assert_true(g->edges[i].kind == WAITFOR_ANY_NODE && g->edges[i].to < 3);
    deadlock_graph_free(g);
    waitfor_free(w);
}

/* However many states there are, the picture stays small, and no node is lost; no box hides another. */
static void test_many_states(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(200);
    for (uint32_t i = 0; i < 200; i++)
        wait_for(w, i, 100 + i, i < 40 ? (i + 1) % 40 : 0);
    waitfor_analyse(w);
    struct deadlock_graph *g = deadlock_graph_make(w);
    struct deadlock_layout l = deadlock_layout_make(g);
    uint32_t nodes = 0;
    assert_in_range(g->count, 2, DEADLOCK_MOST_BOXES);
    for (uint32_t k = 0; k < g->count; k++) {
        struct plot a = l.places[k];
        nodes += g->boxes[k].count;
        assert_true(a.x >= 0 && a.x + a.w <= CANVAS_WIDTH && a.y + a.h <= l.height);
        for (uint32_t j = 0; j < k; j++) {
            struct plot b = l.places[j];
            assert_true(a.x >= b.x + b.w || b.x >= a.x + a.w || a.y >= b.y + b.h || b.y >= a.y + a.h);
        }
    }
    assert_int_equal(nodes, 200);
    free(l.places);
    deadlock_graph_free(g);
    waitfor_free(w);
}

/* No box touches another, nor the shadow that a box of several nodes has, however many there are. */
static void test_apart(void **state)
{
    (void)state;
    const double shadow = 6;
    for (uint32_t count = 2; count <= DEADLOCK_MOST_BOXES; count++) {
        const struct deadlock_graph g = {.count = count};
        struct deadlock_layout l = deadlock_layout_make(&g);
        for (uint32_t k = 0; k < count; k++)
            for (uint32_t j = 0; j < k; j++) {
                struct plot a = l.places[k], b = l.places[j];
                assert_true(fabs(a.x - b.x) >= a.w + shadow || fabs(a.y - b.y) >= a.h + shadow);
            }
        free(l.places);
    }
}

static void summary_says(long awaited, const char *expected)
{
    struct waitfor *w = ring_as_it_is(3);
    for (uint32_t i = 0; i < 3; i++)
        wait_for(w, i, 7, awaited < 0 || i == 0 ? WAITFOR_ANY : awaited);
    waitfor_analyse(w);
    assert_true(w->knot);
    char *summary = deadlock_draw_summary(w);
    assert_string_equal(summary, expected);
    free(summary);
    waitfor_free(w);
}

/* All that wait for a single one that anybody could free are a knot, too, but that one is the reason. */
static void test_summary(void **state)
{
    (void)state;
    summary_says(WAITFOR_ANY, "3 of 3 programs wait; a knot: each for a message that any other could send");
    summary_says(0, "3 of 3 programs wait; no cycle: what has a thick frame has a reason of its own");
}

static void legend_says(const struct waitfor *w, const char *expected)
{
    struct deadlock_graph *g = deadlock_graph_make(w);
    char *legend = deadlock_draw_legend(g);
    assert_string_equal(legend, expected);
    free(legend);
    deadlock_graph_free(g);
}

/* The legend explains what the picture has, and nothing that it has not. */
static void test_legend(void **state)
{
    (void)state;
    struct waitfor *w = ring(4);
    legend_says(w, "An arrow leads to the node that could end the wait. Thick: the cycle.");
    waitfor_free(w);
    w = ring(40);
    legend_says(
        w,
        "An arrow leads to the node that could end the wait. Thick: the cycle. Double box: several nodes.");
    waitfor_free(w);
    w = waitfor_new(4);
    for (uint32_t i = 0; i < 3; i++)
        wait_for(w, i, 7, WAITFOR_ANY);
    w->nodes[3].state = WAITFOR_ENDED;
    waitfor_analyse(w);
    legend_says(
        w, "An arrow leads to the node that could end the wait. Dashed: any one of these would do. Grey box: "
           "does not wait.");
    waitfor_free(w);
}

/* What is read again says what has been written. */
static void test_read(void **state)
{
    (void)state;
    struct waitfor *w = ring_as_it_is(6), *read;
    char *text[2], *error = NULL;
    size_t size;
    waitfor_add_message(&w->nodes[2], &(struct waitfor_message){.type = 9, .from = 1, .bytes = 100});
    waitfor_analyse(w);
    FILE *f = fopen("deadlock.json", "w");
    waitfor_write_json(w, f);
    fclose(f);
    read = deadlock_read("deadlock.json", &error);
    assert_non_null(read);
    for (int i = 0; i < 2; i++) {
        f = open_memstream(&text[i], &size);
        waitfor_write_text(i ? read : w, f);
        fclose(f);
    }
    assert_string_equal(text[0], text[1]);
    char *svg = deadlock_draw_svg(read);
    assert_non_null(strstr(svg, "<svg"));
    free(svg);
    free(text[0]);
    free(text[1]);
    waitfor_free(read);
    waitfor_free(w);
    remove("deadlock.json");
    canvas_forget_fonts();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_small_cycle), cmocka_unit_test(test_long_cycle),
        cmocka_unit_test(test_groups),      cmocka_unit_test(test_any),
        cmocka_unit_test(test_many_states), cmocka_unit_test(test_apart),
        cmocka_unit_test(test_legend),      cmocka_unit_test(test_read),
        cmocka_unit_test(test_summary),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
