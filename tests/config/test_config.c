/* test_config.c - machine files: the shipped ones hold what their sources say; a bad one is named by line and
 * key. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "config/config.h"

#define US 1000000ull

static struct cfg_machine *shipped(const char *name)
{
    char home[4096], *error = NULL;
    assert_true(cfg_home(home, sizeof home - 16));
    strcat(home, "/machines");
    struct cfg_machine *m = cfg_load(name, home, &error);
    if (!m)
        print_error("%s\n", error);
    assert_non_null(m);
    return m;
}

static void ipsc860_adds_up_to_bokhari(void **state)
{
    (void)state;
    struct cfg_machine *m = shipped("ipsc860");
    assert_int_equal(m->topology, CFG_HYPERCUBE);
    assert_int_equal(m->dimension, 7);
    assert_int_equal(m->clock_hz, 40000000);
    assert_int_equal(m->memory_bytes, 16 << 20);
    assert_int_equal(m->short_send_ps + m->short_receive_ps, 65 * US);
    assert_int_equal(m->short_ps_per_byte, 425000);
    assert_int_equal(m->short_hop_ps, 10 * US);
    assert_int_equal(m->ask_send_ps + m->ask_receive_ps + m->grant_receive_ps + m->long_receive_ps, 147 * US);
    assert_int_equal(m->long_ps_per_byte, 390000);
    assert_in_range(3 * m->long_hop_ps, 30500000 - 1, 30500000 + 1);
    assert_int_equal(m->short_limit, 100);
    assert_int_equal(m->forced_send_ps + m->forced_receive_ps, 95 * US);
    assert_int_equal(m->kernel_ps, 0);
    cfg_free(m);
}

static void longer_forced_messages_are_as_short_ones_where_the_file_does_not_say(void **state)
{
    (void)state;
    struct cfg_machine *m = shipped("delta");
    assert_int_equal(m->forced_send_ps, m->short_send_ps);
    assert_int_equal(m->forced_receive_ps, m->short_receive_ps);
    cfg_free(m);
}

static void masktrap_takes_65_to_70_us_on_a_paragon(void **state)
{
    (void)state;
    static const char *const names[] = {"paragon", "paragon95"};
    for (int i = 0; i < 2; i++) {
        struct cfg_machine *m = shipped(names[i]);
        assert_in_range(m->clock_call_ps + m->kernel_ps, 65 * US, 70 * US);
        cfg_free(m);
    }
}

static void gettimeofday_takes_0_3_ms_on_a_paragon(void **state)
{
    (void)state;
    struct cfg_machine *paragon = shipped("paragon"), *delta = shipped("delta");
    assert_int_equal(paragon->clock_call_ps + paragon->unix_call_ps, 305 * US);
    assert_int_equal(delta->unix_call_ps, 0);
    cfg_free(paragon), cfg_free(delta);
}

/* OSF/1 of early 1994: the processor moves one message at once, and a file's client has a cost. */
static void a_paragon_s_processor_moves_messages_and_files(void **state)
{
    (void)state;
    struct cfg_machine *paragon = shipped("paragon"), *delta = shipped("delta");
    assert_int_equal(paragon->moves_at_once, 1);
    assert_int_equal(paragon->send_ps_per_byte, paragon->long_ps_per_byte);
    assert_int_equal(paragon->receive_ps_per_byte, paragon->long_ps_per_byte);
    assert_int_equal(paragon->cfs.client_ps, 7400 * US);
    assert_int_equal(paragon->cfs.client_ps_per_byte + paragon->long_ps_per_byte, 80000);
    assert_int_equal(delta->moves_at_once, 0);
    assert_int_equal(delta->cfs.client_ps + delta->cfs.client_ps_per_byte, 0);
    cfg_free(paragon), cfg_free(delta);
}

static void delta_is_a_mesh_of_528(void **state)
{
    (void)state;
    struct cfg_machine *m = shipped("delta");
    assert_string_equal(m->name, "delta");
    assert_int_equal(m->topology, CFG_MESH);
    assert_int_equal(m->rows * m->columns, 528);
    assert_int_equal(m->short_hop_ps, 100000);
    assert_int_equal(m->long_ps_per_byte, 125000);
    assert_int_equal(m->short_send_ps + m->short_receive_ps, 75 * US);
    assert_non_null(strstr(m->cpu, "machines/cpu/i860.cfg"));
    cfg_free(m);
}

static void unknown_name_lists_the_known(void **state)
{
    (void)state;
    char home[4096], *error = NULL;
    assert_true(cfg_home(home, sizeof home - 16));
    strcat(home, "/machines");
    assert_null(cfg_load("detla", home, &error));
    assert_non_null(strstr(error, "no machine \"detla\""));
    assert_non_null(strstr(error, "did you mean delta? There are: cluster2026, delta, ipsc860"));
    free(error);
    assert_null(cfg_load("sequoia", home, &error));
    assert_non_null(strstr(error, "; there are: cluster2026, delta"));
    free(error);
}

static void hwclock_counts_at_10_mhz_and_on_the_paragon_at_50(void **state)
{
    (void)state;
    static const char *const names[] = {"ipsc860", "delta", "paragon"};
    for (int i = 0; i < 3; i++) {
        struct cfg_machine *m = shipped(names[i]);
        assert_int_equal(m->hwclock_hz, i == 2 ? 50000000 : 10000000);
        cfg_free(m);
    }
}

static void file_systems_are_as_published(void **state)
{
    (void)state;
    struct cfg_machine *m = shipped("ipsc860");
    assert_int_equal(m->cfs.io_nodes, 10);
    assert_int_equal(m->cfs.disks, 10);
    assert_int_equal(m->cfs.block_bytes, 4096);
    assert_int_equal(m->cfs.disk_ps_per_byte, US); /* 1 MB/s */
    assert_int_equal(m->cfs.rotation_ps, 8330 * US);
    cfg_free(m);
    m = shipped("delta");
    assert_int_equal(m->cfs.io_nodes, 32);
    assert_int_equal(m->cfs.disks, 64);
    cfg_free(m);
}

/* A good file; a test changes one line of it. Lines are counted from 1. */
static const char *const good[] = {
    /* 1 */ "name = \"toy\"; description = \"for tests\";",
    /* 2 */ "topology = { kind = \"mesh\";",
    /* 3 */ "rows = 2; columns = 3;",
    /* 4 */ "};",
    /* 5 */ "node = { cpu = \"/dev/null\"; clock_mhz = 50; memory_mb = 16; system_kb = 1024;",
    /* 6 */ "stack_kb = 64;",
    /* 7 */ "};",
    /* 8 */
    "net = { short_hop_us = 1; long_hop_ns = 2.5; short_us_per_byte = 0.1; long_ns_per_byte = 0.0004;",
    /* 9 */ "short_limit = 100;",
    /* 10 */ "};",
    /* 11 */ "system = { call_us = 1; clock_call_us = 1; short_send_us = 1; short_receive_us = 1;",
    /* 12 */ "ask_send_us = 1; ask_receive_us = 1; grant_receive_us = 1; long_receive_us = 1;",
    /* 13 */ "send_us_per_byte = 1; receive_us_per_byte = 1; copy_us_per_byte = 1;",
    /* 14 */ "interrupt_us = 1;",
    /* 15 */ "message_ids = 9; };",
};
enum { LINES = sizeof good / sizeof *good };

/* Loads the good file with line number `line` replaced; the path is PATH below. */
#define PATH "toy.cfg"
static struct cfg_machine *load_with(int line, const char *text, char **error)
{
    FILE *out = fopen(PATH, "w");
    assert_non_null(out);
    for (int i = 0; i < LINES; i++)
        fprintf(out, "%s\n", i + 1 == line ? text : good[i]);
    fclose(out);
    return cfg_load(PATH, "nowhere", error);
}

static void times_are_exact_picoseconds(void **state)
{
    (void)state;
    char *error = NULL;
    struct cfg_machine *m = load_with(0, NULL, &error);
    assert_non_null(m);
    assert_int_equal(m->short_hop_ps, US);
    assert_int_equal(m->long_hop_ps, 2500);
    assert_int_equal(m->short_ps_per_byte, 100000);
    assert_int_equal(m->long_ps_per_byte, 0); /* 0.4 ps: to the nearest */
    assert_int_equal(m->clock_hz, 50000000);
    assert_string_equal(m->path, PATH);
    cfg_free(m);
}

#define HOST                                                                                                 \
    "clock_mhz = 16.0; cpu_factor = 4.0; memory_mb = 8; system_factor = 2.5; link_us = 7; load_ms = 3.0;"    \
    " cube_ms = 0.5;"

static void a_host_is_a_slower_processor_behind_a_link(void **state)
{
    (void)state;
    struct cfg_machine *m = shipped("ipsc860");
    assert_true(m->host.clock_hz > 0 && m->host.clock_hz < m->clock_hz);
    assert_true(m->host.system_milli > 1000);
    assert_true(m->host.link_ps_per_byte >= m->long_ps_per_byte);
    cfg_free(m);
    m = shipped("delta");
    assert_int_equal(m->host.clock_hz, 0);
    cfg_free(m);

    const char *const set[] = {"host.cpu_factor=4.0", "host.system_factor=2.5", "host.load_ms=3.0", NULL};
    char home[4096], *error = NULL;
    assert_true(cfg_home(home, sizeof home - 16));
    strcat(home, "/machines");
    m = cfg_load_with("ipsc860", home, set, &error);
    assert_int_equal(m->host.clock_hz, 4000000);
    assert_int_equal(m->host.system_milli, 2500);
    assert_int_equal(m->host.load_ps, 3000 * US);
    cfg_free(m);
    const char *const fast[] = {"host.link_us_per_byte=0.1", NULL};
    assert_null(cfg_load_with("ipsc860", home, fast, &error));
    assert_non_null(strstr(error, "link_us_per_byte: the link is faster than the channels between nodes"));
    free(error);
}

static void bad_files_are_named_by_line_and_key(void **state)
{
    (void)state;
    static const struct {
        int line;
        const char *text, *error;
    } cases[] = {
        {3, "rows = 2; colums = 3;",
         "toy.cfg:3: colums: unknown key; did you mean columns? Known here: kind, rows, columns"},
        {3, "rows = 2;", "toy.cfg:2: columns: missing"},
        {3, "rows = 0; columns = 3;", "toy.cfg:3: rows: 0 is out of range: 1 to 4096 are allowed"},
        {3, "rows = -1; columns = 3;", "toy.cfg:3: rows: -1 is out of range: 1 to 4096 are allowed"},
        {3, "rows = 2.5; columns = 3;", "toy.cfg:3: rows: must be a whole number from 1 to 4096"},
        {3, "rows = 4000; columns = 3000;",
         "toy.cfg:2: topology: 4000 x 3000 nodes; at most 1048576 are allowed"},
        {2, "topology = { kind = \"ring\";",
         "toy.cfg:2: kind: \"ring\" is unknown; \"hypercube\" and \"mesh\" are allowed"},
        {2, "topology = { kind = \"hypercube\";",
         "toy.cfg:3: rows: unknown key; known here: kind, dimension"},
        {2, "topology = { kind = 7;", "toy.cfg:2: kind: must be text in double quotes, not empty"},
        {1, "name = \"toy\";", "toy.cfg: description: missing"},
        {1, "name = \"toy\"; description = \"\";",
         "toy.cfg:1: description: must be text in double quotes, not empty"},
        {5, "node = { cpu = \"/no/such.cfg\"; clock_mhz = 50; memory_mb = 16; system_kb = 1024;",
         "toy.cfg:5: cpu: /no/such.cfg cannot be read: No such file or directory"},
        {5, "node = { cpu = \"/dev/null\"; clock_mhz = 0; memory_mb = 16; system_kb = 1024;",
         "toy.cfg:5: clock_mhz: 0 is out of range: 0.001 to 100000 are allowed"},
        {6, "stack_kb = 15360;",
         "toy.cfg:5: memory_mb: system_kb and stack_kb leave nothing of it to the program"},
        {6, "stack_kb = \"64\";", "toy.cfg:6: stack_kb: must be a whole number from 16 to 16384"},
        {9, "short_limit = 100; short_hop_ns = 3;",
         "toy.cfg:9: short_hop_ns: short_hop_us is given too: one of them only"},
        {13, "send_us_per_byte = 1; receive_us_per_byte = 1001; copy_us_per_byte = 1;",
         "toy.cfg:13: receive_us_per_byte: 1001 is out of range: 0 to 1000 are allowed"},
        {14, "interrupt_us = \"long\";", "toy.cfg:14: interrupt_us: must be a number from 0 to 1e+06"},
        {14, "interrupt_us = -1.0;", "toy.cfg:14: interrupt_us: -1 is out of range: 0 to 1e+06 are allowed"},
        {14, "", "toy.cfg:11: interrupt_us: missing"},
        {15, "message_ids = 0; };", "toy.cfg:15: message_ids: 0 is out of range: 1 to 1000000 are allowed"},
        {15, "message_ids = 9; moves_at_once = -1; };",
         "toy.cfg:15: moves_at_once: -1 is out of range: 0 to 1000 are allowed"},
        {1, "name = \"toy\"; description = \"for tests\"; cfs = { io_nodes = 2; disks = 1; };",
         "toy.cfg:1: disks: 1 is too few for io_nodes = 2: each I/O node has a disk at least"},
        {1, "name = \"toy\"; description = \"for tests\"; cfs = { io_nodes = 2; discs = 1; };",
         "toy.cfg:1: discs: unknown key; did you mean disks? Known here: io_nodes, disks"},
        {1, "name = \"toy\"; description = \"for tests\"; host = { " HOST " link_us_per_byte = 1; };",
         "toy.cfg:1: a host is attached to node 0 of a hypercube; this machine is a mesh"},
        {1, "name = \"toy\"; description = \"for tests\"; host = { " HOST " };",
         "toy.cfg:1: link_us_per_byte: missing"},
        {1, "name = \"toy\"; description = \"for tests\"; host = { clock_mz = 1; };",
         "toy.cfg:1: clock_mz: unknown key; did you mean clock_mhz? Known here: clock_mhz, cpu_factor"},
        {14, "interrupt_us 1;", "toy.cfg:14: syntax error (settings are written: key = value;)"},
        {14, "interrupt_us = 1; call_us = 2;",
         "toy.cfg:14: duplicate setting name (settings are written: key = value;)"},
        {7, "", "toy.cfg:"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char *error = NULL;
        struct cfg_machine *m = load_with(cases[i].line, cases[i].text, &error);
        assert_null(m);
        assert_non_null(error);
        error[strnlen(error, strlen(cases[i].error))] = '\0'; /* the rest of a list of known keys */
        assert_string_equal(error, cases[i].error);
        free(error);
    }
}

/* "folder/toy.inc", not "toy.inc": there is none where the user is. */
static void included_files_are_named_by_path(void **state)
{
    (void)state;
    static const char *const cases[][2] = {
        {"/* as before:\n@include \"none.inc\"\n*/ name = \"/*\"; description = 7;",
         "folder/toy.inc:3: description: must be text in double quotes, not empty"},
        {"name = 7;", "folder/toy.inc:1: name: must be text in double quotes, not empty"},
        {"\xef\xbb\xbfname = 7;", "folder/toy.inc:1: begins with a byte order mark: save it without one"},
        {"name = ;", "folder/toy.inc:1: syntax error (settings are written: key = value;)"}};
    assert_int_equal(mkdir("folder", 0777), 0);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char *error = NULL;
        FILE *toy = fopen("folder/toy.cfg", "w"), *inc = fopen("folder/toy.inc", "w");
        assert_true(toy && inc);
        fprintf(toy, "\xef\xbb\xbf@include \"toy.inc\"\n"); /* with a byte order mark, which is no matter */
        fprintf(inc, "%s\n", cases[i][0]);
        fclose(toy), fclose(inc);
        assert_null(cfg_load("folder/toy.cfg", "nowhere", &error));
        assert_string_equal(error, cases[i][1]);
        free(error);
    }
    char *error = NULL;
    unlink("folder/toy.inc");
    assert_null(cfg_load("folder/toy.cfg", "nowhere", &error));
    assert_string_equal(error, "folder/toy.cfg:1: @include: folder/toy.inc cannot be read: No such file or "
                               "directory (a path from this file's folder)");
    free(error);
    unlink("folder/toy.cfg");
    assert_int_equal(rmdir("folder"), 0);
}

static void file_that_is_not_there(void **state)
{
    (void)state;
    char *error = NULL;
    assert_null(cfg_load("./none.cfg", "nowhere", &error));
    assert_string_equal(error, "./none.cfg: cannot be read: No such file or directory");
    free(error);
}

/* The bad files are written to a folder of the test's own. */
static char scratch[] = "/tmp/test_config.XXXXXX";
static int enter_scratch(void **state)
{
    (void)state;
    return mkdtemp(scratch) && chdir(scratch) == 0 ? 0 : -1;
}
static int leave_scratch(void **state)
{
    (void)state;
    unlink(PATH);
    return rmdir(scratch);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ipsc860_adds_up_to_bokhari),
        cmocka_unit_test(longer_forced_messages_are_as_short_ones_where_the_file_does_not_say),
        cmocka_unit_test(masktrap_takes_65_to_70_us_on_a_paragon),
        cmocka_unit_test(gettimeofday_takes_0_3_ms_on_a_paragon),
        cmocka_unit_test(a_paragon_s_processor_moves_messages_and_files),
        cmocka_unit_test(delta_is_a_mesh_of_528),
        cmocka_unit_test(hwclock_counts_at_10_mhz_and_on_the_paragon_at_50),
        cmocka_unit_test(file_systems_are_as_published),
        cmocka_unit_test(unknown_name_lists_the_known),
        cmocka_unit_test(a_host_is_a_slower_processor_behind_a_link),
        cmocka_unit_test(times_are_exact_picoseconds),
        cmocka_unit_test(bad_files_are_named_by_line_and_key),
        cmocka_unit_test(included_files_are_named_by_path),
        cmocka_unit_test(file_that_is_not_there),
    };
    return cmocka_run_group_tests(tests, enter_scratch, leave_scratch);
}
