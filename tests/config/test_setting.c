/* test_setting.c - settings given besides a machine file replace its values, and have the same ranges. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <stdlib.h>
#include <string.h>

#include "config/config.h"

#define US 1000000ull

/* The shipped machine with one setting or two. */
static struct cfg_machine *delta_with(const char *set, const char *more, char **error)
{
    char home[4096];
    assert_true(cfg_home(home, sizeof home - 16));
    strcat(home, "/machines");
    return cfg_load_with("delta", home, (const char *const[]){set, more, NULL}, error);
}

static void a_setting_takes_the_place_of_the_files(void **state)
{
    (void)state;
    char *error = NULL;
    struct cfg_machine *m = delta_with("system.interrupt_us=151", "topology.rows=4", &error);
    assert_non_null(m);
    assert_int_equal(m->interrupt_ps, 151 * US);
    assert_int_equal(m->rows, 4);
    assert_int_equal(m->columns, 33);
    assert_string_equal(m->set[0], "system.interrupt_us=151");
    assert_string_equal(m->set[1], "topology.rows=4");
    assert_null(m->set[2]);
    cfg_free(m);
}

static void the_last_of_two_settings_counts(void **state)
{
    (void)state;
    char *error = NULL;
    struct cfg_machine *m = delta_with("net.short_limit=50", "net.short_limit=60", &error);
    assert_non_null(m);
    assert_int_equal(m->short_limit, 60);
    cfg_free(m);
}

static void a_setting_may_be_in_another_unit_than_the_files(void **state)
{
    (void)state;
    char *error = NULL;
    struct cfg_machine *m = delta_with("net.short_hop_us=0.098", "net.long_ns_per_byte=500", &error);
    assert_non_null(m);
    assert_int_equal(m->short_hop_ps, 98000);
    assert_int_equal(m->long_ps_per_byte, 500000);
    cfg_free(m);
}

static void a_setting_may_be_of_an_optional_key(void **state)
{
    (void)state;
    char *error = NULL;
    struct cfg_machine *m = delta_with("net.channel_ns_per_byte=40", NULL, &error);
    assert_non_null(m);
    assert_int_equal(m->channel_ps_per_byte, 40000);
    cfg_free(m);
}

static void the_clocks_of_nodes_are_within_a_factor(void **state)
{
    (void)state;
    char *error = NULL;
    struct cfg_machine *m = delta_with("node.fast_every=2", "node.fast_clock_mhz=0.04", &error);
    assert_non_null(m);
    cfg_free(m);
    assert_null(delta_with("node.fast_every=2", "node.fast_clock_mhz=0.039", &error));
    assert_non_null(strstr(error, "fast_clock_mhz: must be a thousandth of clock_mhz at least"));
    free(error);
    assert_null(delta_with("node.fast_every=2", "node.fast_clock_mhz=40001", &error));
    free(error);
}

static void bad_settings_are_checked_as_the_file_is(void **state)
{
    (void)state;
    static const struct {
        const char *set, *error;
    } cases[] = {
        {"system.interupt_us=1",
         "system.interupt_us=1: interupt_us: unknown key; did you mean interrupt_us? Known here: call_us, "},
        {"system.interrupt_us=-1",
         "system.interrupt_us=-1: interrupt_us: -1 is out of range: 0 to 1e+06 are allowed"},
        {"system.message_ids=99999999999999999999",
         "system.message_ids=99999999999999999999: message_ids: must be a whole number from 1 to 1000000"},
        {"mpi_collectives=2000", "mpi_collectives=2000: mpi_collectives: must be 1995 or 2005"},
        {"system.interrupt_us=long",
         "system.interrupt_us=long: interrupt_us: must be a number from 0 to 1e+06"},
        {"system.interrupt_us=", "system.interrupt_us=: interrupt_us: must be a number from 0 to 1e+06"},
        {"system.interrupt_us=nan",
         "system.interrupt_us=nan: interrupt_us: must be a number from 0 to 1e+06"},
        {"topology.rows=2.5", "topology.rows=2.5: rows: must be a whole number from 1 to 4096"},
        {"rows=4",
         "rows=4: rows: unknown key; known here: name, description, topology, node, net, system, cfs"},
        {"sistem.call_us=1", "sistem.call_us=1: there is no group sistem; there are: topology, node, net, "},
        {"topology.kind.x=1", "topology.kind.x=1: there is no group topology.kind; there are: topology, "},
        {"topology.my rows=4", "topology.my rows=4: 'my rows' is no key"},
        {"topology.rows", "topology.rows: a setting is KEY=VALUE, such as system.interrupt_us=150"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char *error = NULL;
        assert_null(delta_with(cases[i].set, NULL, &error));
        assert_non_null(error);
        assert_non_null(strstr(error, cases[i].error)); /* before it may be the file's name */
        free(error);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_setting_takes_the_place_of_the_files),
        cmocka_unit_test(the_last_of_two_settings_counts),
        cmocka_unit_test(a_setting_may_be_in_another_unit_than_the_files),
        cmocka_unit_test(a_setting_may_be_of_an_optional_key),
        cmocka_unit_test(the_clocks_of_nodes_are_within_a_factor),
        cmocka_unit_test(bad_settings_are_checked_as_the_file_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
