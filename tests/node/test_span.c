/* The address space of nodes: guards lie between all parts as far as the host allows mappings, and the
 * parts of a node lie near to each other. */
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cmocka.h>
#include "guest/span.h"
#include "guest/span_texts.h"
#include "node/system.h"
#include "node/self.h"

enum { NODES = 3, CUBE = 128, PROGRAM = 100 << 10 };

static struct cfg_machine cfg = {.memory_bytes = 16 << 20, .system_bytes = 1 << 20, .stack_bytes = 512 << 10};

struct machine {
    struct node_system sys;
    struct node node[NODES];
};

/* count: the number of nodes that the machine says it has. most: mappings; 0: as many as the host allows,
 * and lighter guards. */
static void take(struct machine *m, uint32_t count, size_t most, bool long32)
{
    m->sys =
        (struct node_system){.cfg = &cfg, .count = count, .most_mappings = most, .guards = NODE_GUARDS_ALL};
    for (int i = 0; i < NODES; i++) {
        m->node[i] = (struct node){.sys = &m->sys, .id = (uint32_t)i};
        assert_true(span_take(&m->node[i], NULL, PROGRAM, 0, long32, false));
    }
}

static void release(struct machine *m)
{
    for (int i = 0; i < NODES; i++)
        span_release(&m->node[i]);
    span_texts_free(m->sys.texts);
}

/* Can a byte be written? A child process tries, since it may die of it. */
static bool is_there(char *byte)
{
    int status;
    pid_t child = fork();
    if (child == 0) {
        signal(SIGSEGV, SIG_DFL);
        *(volatile char *)byte = 1;
        _exit(0);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

static void check_guards(struct machine *m, bool data, bool stacks)
{
    for (int i = 0; i < NODES; i++) {
        struct node *n = &m->node[i];
        char *heap_end = n->guest.heap_start + n->guest.region->heap_bytes;
        assert_true(is_there(n->guest.stack) && is_there(n->guest.program) &&
                    is_there(n->guest.program + PROGRAM - 1));
        assert_true(is_there(n->guest.heap_start) && is_there(heap_end - 1));
        assert_int_equal(is_there(n->guest.stack - 1), !stacks);
        assert_int_equal(is_there(n->guest.program + PROGRAM), !data);
        assert_true(is_there(heap_end));
        span_guard_heap(n);
        assert_int_equal(is_there(heap_end), !data);
    }
}

static void all_parts_are_guarded(void **state)
{
    struct machine m;
    (void)state;
    take(&m, NODES, 0, false);
    check_guards(&m, true, true);
    assert_int_equal(m.sys.guards, NODE_GUARDS_ALL);
    release(&m);
}

/* As on kernels without lighter guards, where each guard is a mapping. */
static void guards_are_given_up_when_there_are_too_many_nodes_for_them(void **state)
{
    struct machine m;
    (void)state;
    take(&m, 7900, 65530, false);
    check_guards(&m, true, true);
    assert_false(m.node[0].guest.region->copies_text);
    release(&m);
    take(&m, 10500, 65530, false);
    check_guards(&m, true, true);
    assert_true(m.node[0].guest.region->copies_text);
    release(&m);
    take(&m, 15800, 65530, false);
    check_guards(&m, false, true);
    assert_int_equal(m.sys.guards, NODE_GUARDS_STACKS);
    release(&m);
    take(&m, 65536, 65530, false);
    check_guards(&m, false, false);
    assert_int_equal(m.sys.guards, NODE_GUARDS_NONE);
    release(&m);
}

static void all_memory_tells_whose_it_is(void **state)
{
    struct machine m;
    (void)state;
    take(&m, NODES, 0, false);
    for (int i = 0; i < NODES; i++) {
        struct node *n = &m.node[i];
        char *parts[] = {n->guest.system_stack, n->guest.stack,
                         n->guest.program,      n->guest.program + PROGRAM - 1,
                         n->guest.heap_start,   n->guest.heap_start + n->guest.region->heap_bytes - 1};
        for (size_t k = 0; k < sizeof parts / sizeof *parts; k++) {
            if (parts[k] < n->guest.heap_start)
                assert_ptr_equal(node_at_address((uintptr_t)parts[k]), n);
            for (int j = 0; j < NODES; j++)
                assert_int_equal(node_owns(&m.node[j], (uintptr_t)parts[k]), i == j);
        }
    }
    release(&m);
}

static void a_nodes_parts_are_near_to_each_other(void **state)
{
    struct machine m;
    (void)state;
    for (uint64_t memory = 2 << 20; memory <= 512 << 20; memory *= 2) {
        cfg.memory_bytes = memory;
        take(&m, NODES, 0, false);
        for (int i = 0; i < NODES; i++) {
            const struct node *n = &m.node[i];
            assert_true(n->guest.heap_start + n->guest.region->heap_bytes - n->guest.stack < 1L << 30);
            assert_true(n->guest.heap_start > n->guest.program);
        }
        release(&m);
    }
    cfg.memory_bytes = 16 << 20;
}

static void a_node_has_addresses_for_all_of_its_memory(void **state)
{
    struct machine m;
    (void)state;
    for (uint64_t memory = 1 << 30; memory <= UINT64_C(32) << 30; memory *= 2) {
        cfg.memory_bytes = memory;
        take(&m, NODES, 0, false);
        for (int i = 0; i < NODES; i++) {
            char *heap = m.node[i].guest.heap_start;
            assert_true(m.node[i].guest.region->heap_bytes >= memory - cfg.system_bytes);
            assert_true(is_there(heap) && is_there(heap + m.node[i].guest.region->heap_bytes - 1));
            for (int j = 0; j < NODES; j++)
                assert_int_equal(node_owns(&m.node[j], (uintptr_t)heap + memory / 2), i == j);
        }
        release(&m);
    }
    cfg.memory_bytes = 16 << 20;
}

/* The lower half of an address there could be that of another node's memory below 4 GB. */
static void an_address_above_4_gb_is_nobodys_if_a_program_keeps_it_in_an_int(void **state)
{
    struct node_system sys = {.cfg = &cfg, .count = 5 * CUBE, .guards = NODE_GUARDS_ALL};
    static struct node node[5 * CUBE];
    uint32_t above = 0;
    (void)state;
    for (uint32_t i = 0; i < sys.count; i++) {
        node[i] = (struct node){.sys = &sys, .id = i};
        assert_true(span_take(&node[i], NULL, PROGRAM, 0, true, false));
        uintptr_t at = (uintptr_t)node[i].guest.stack;
        intptr_t kept = (int)at;
        above += at > UINT32_MAX;
        for (uint32_t k = 0; at > UINT32_MAX && k < i; k++)
            assert_false(node_owns(&node[k], (uintptr_t)kept));
    }
    assert_true(above > 2 * CUBE);
    for (uint32_t i = 0; i < sys.count; i++)
        span_release(&node[i]);
}

static void a_cube_of_programs_with_a_long_of_32_bits_lies_below_2_gb(void **state)
{
    struct node_system sys = {.cfg = &cfg, .count = CUBE, .guards = NODE_GUARDS_ALL};
    static struct node node[CUBE];
    (void)state;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    skip(); /* sanitizers have their own memory there */
#endif
    cfg.system_bytes = 3 << 19;
    for (int i = 0; i < CUBE; i++) {
        node[i] = (struct node){.sys = &sys, .id = (uint32_t)i};
        assert_true(span_take(&node[i], NULL, PROGRAM, 0, true, false));
        assert_true((uintptr_t)node[i].guest.heap_start + node[i].guest.region->heap_bytes < UINT64_C(1)
                                                                                                 << 31);
    }
    for (int i = 0; i < CUBE; i++)
        span_release(&node[i]);
    cfg.system_bytes = 1 << 20;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_parts_are_guarded),
        cmocka_unit_test(guards_are_given_up_when_there_are_too_many_nodes_for_them),
        cmocka_unit_test(all_memory_tells_whose_it_is),
        cmocka_unit_test(a_nodes_parts_are_near_to_each_other),
        cmocka_unit_test(a_node_has_addresses_for_all_of_its_memory),
        cmocka_unit_test(an_address_above_4_gb_is_nobodys_if_a_program_keeps_it_in_an_int),
        cmocka_unit_test(a_cube_of_programs_with_a_long_of_32_bits_lies_below_2_gb),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
