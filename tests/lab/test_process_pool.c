/* test_process_pool.c - the process pool: the order of jobs, how many run at a time, their output, how they
 * end. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <signal.h>
#include <string.h>
#include <unistd.h>

#include "lab/jobs/process_pool.h"

#define SH(script)                                                                                           \
    (char *[])                                                                                               \
    {                                                                                                        \
        "/bin/sh", "-c", script, NULL                                                                        \
    }

/* Records the order in which jobs ended, and the most that ran at once. */
struct log {
    const struct pool_job *ended[16];
    size_t count, most_running;
};

static void note(void *arg, const struct pool_status *s)
{
    struct log *log = arg;
    if (s->finished)
        log->ended[log->count++] = s->finished;
    if (s->running > log->most_running)
        log->most_running = s->running;
}

static void output_is_kept_apart(void **state)
{
    (void)state;
    struct pool_job jobs[] = {{.name = "a", .argv = SH("echo one; echo noise >&2; echo two")},
                              {.name = "b", .argv = SH("printf three")}};
    assert_true(pool_run(jobs, 2, 2, NULL).all_done);
    assert_string_equal(jobs[0].out, "one\ntwo\n");
    assert_string_equal(jobs[1].out, "three");
    assert_int_equal(jobs[0].state, POOL_DONE);
    assert_null(jobs[0].error);
    pool_clear(jobs, 2);
}

static void longest_start_first(void **state)
{
    (void)state;
    struct log log = {0};
    struct pool_watcher watcher = {note, &log};
    struct pool_job jobs[] = {
        {.name = "short", .argv = SH(":"), .weight = 1},
        {.name = "long", .argv = SH(":"), .weight = 3},
        {.name = "middle", .argv = SH(":"), .weight = 2},
        {.name = "middle too", .argv = SH(":"), .weight = 2},
    };
    assert_true(pool_run(jobs, 4, 1, &watcher).all_done);
    assert_int_equal(log.count, 4);
    assert_ptr_equal(log.ended[0], &jobs[1]);
    assert_ptr_equal(log.ended[1], &jobs[2]);
    assert_ptr_equal(log.ended[2], &jobs[3]);
    assert_ptr_equal(log.ended[3], &jobs[0]);
    pool_clear(jobs, 4);
}

static void a_lower_turn_starts_first(void **state)
{
    (void)state;
    struct log log = {0};
    struct pool_watcher watcher = {note, &log};
    struct pool_job jobs[] = {
        {.name = "long, second", .argv = SH(":"), .turn = 1, .weight = 3},
        {.name = "short, first", .argv = SH(":"), .weight = 1},
        {.name = "middle, first", .argv = SH(":"), .weight = 2},
    };
    assert_true(pool_run(jobs, 3, 1, &watcher).all_done);
    assert_ptr_equal(log.ended[0], &jobs[2]);
    assert_ptr_equal(log.ended[1], &jobs[1]);
    assert_ptr_equal(log.ended[2], &jobs[0]);
    pool_clear(jobs, 3);
}

static void no_more_than_asked_run_at_once(void **state)
{
    (void)state;
    struct log log = {0};
    struct pool_watcher watcher = {note, &log};
    char *const nap[] = {"sleep", "0.1", NULL};
    struct pool_job jobs[6];
    for (int i = 0; i < 6; i++)
        jobs[i] = (struct pool_job){.name = "nap", .argv = nap};
    struct pool_end end = pool_run(jobs, 6, 3, &watcher);
    assert_true(end.all_done);
    assert_int_equal(log.most_running, 2); /* beside the one that has just ended */
    assert_true(end.wall_time_s > 0.19);
    pool_clear(jobs, 6);
}

static void failures_are_told_and_the_rest_goes_on(void **state)
{
    (void)state;
    struct pool_job jobs[] = {
        {.name = "status", .argv = SH("echo first >&2; echo last words >&2; exit 3")},
        {.name = "signal", .argv = SH("kill -SEGV $$")},
        {.name = "not there", .argv = (char *[]){"/no/such/program", NULL}},
        {.name = "good", .argv = SH("echo good")},
        {.name = "no input", .argv = SH(":"), .in = "/no/such/input"},
    };
    struct pool_end end = pool_run(jobs, 5, 2, NULL);
    assert_false(end.all_done);
    assert_false(end.stopped);
    assert_string_equal(jobs[0].error, "exit status 3: first\nlast words");
    assert_string_equal(jobs[0].err, "first\nlast words\n");
    assert_string_equal(jobs[1].error, "killed by signal 11 (Segmentation fault)");
    assert_string_equal(jobs[2].error,
                        "exit status 127: /no/such/program cannot be run: No such file or directory");
    assert_int_equal(jobs[2].state, POOL_FAILED);
    assert_string_equal(jobs[3].out, "good\n");
    assert_string_equal(jobs[4].error,
                        "exit status 127: its input cannot be read: No such file or directory");
    pool_clear(jobs, 5);
}

static void much_output_is_cut_and_does_not_block(void **state)
{
    (void)state;
    struct pool_job job = {
        .name = "loud", .argv = SH("yes abcdefg | head -c 70000000; yes xyz | head -c 100000 >&2; exit 1")};
    pool_run(&job, 1, 1, NULL);
    assert_int_equal(strlen(job.out), POOL_MAX_OUT);
    assert_true(job.cut);
    assert_memory_equal(job.out, "abcdefg\n", 8);
    assert_int_equal(strlen(job.err), POOL_MAX_ERR);
    assert_true(strlen(job.error) < POOL_MAX_ERR + 64);
    pool_clear(&job, 1);
}

static void a_pipe_held_open_by_a_grandchild_does_not_delay(void **state)
{
    (void)state;
    struct pool_job job = {.name = "leaves one behind", .argv = SH("echo done; sleep 30 & exit 0")};
    struct pool_end end = pool_run(&job, 1, 1, NULL);
    assert_true(end.all_done);
    assert_true(end.wall_time_s < 30);
    assert_string_equal(job.out, "done\n");
    pool_clear(&job, 1);
}

/* (Under nohup the tests themselves begin with SIGHUP ignored.) */
static void stopped_by(int number, char *const *argv)
{
    signal(number, SIG_DFL);
    struct pool_job jobs[] = {{.name = "stops us", .argv = argv, .weight = 2},
                              {.name = "never starts", .argv = SH(":"), .weight = 1}};
    struct pool_end end = pool_run(jobs, 2, 1, NULL);
    assert_int_equal(end.stopped, number);
    assert_true(end.wall_time_s < 300);
    assert_int_equal(jobs[0].state, POOL_FAILED);
    assert_int_equal(jobs[1].state, POOL_WAITING);
    pool_clear(jobs, 2);
}

static void a_signal_ends_the_pool(void **state)
{
    (void)state;
    stopped_by(SIGTERM, SH("kill -TERM $PPID; exec sleep 300"));
    stopped_by(SIGHUP, SH("kill -HUP $PPID; exec sleep 300"));
}

static void an_ignored_hangup_stays_ignored(void **state)
{
    (void)state;
    signal(SIGHUP, SIG_IGN);
    struct pool_job job = {.name = "hangs up", .argv = SH("kill -HUP $PPID; kill -HUP $$; echo on")};
    struct pool_end end = pool_run(&job, 1, 1, NULL);
    signal(SIGHUP, SIG_DFL);
    assert_true(end.all_done);
    assert_string_equal(job.out, "on\n");
    pool_clear(&job, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(output_is_kept_apart),
        cmocka_unit_test(longest_start_first),
        cmocka_unit_test(a_lower_turn_starts_first),
        cmocka_unit_test(no_more_than_asked_run_at_once),
        cmocka_unit_test(failures_are_told_and_the_rest_goes_on),
        cmocka_unit_test(much_output_is_cut_and_does_not_block),
        cmocka_unit_test(a_pipe_held_open_by_a_grandchild_does_not_delay),
        cmocka_unit_test(a_signal_ends_the_pool),
        cmocka_unit_test(an_ignored_hangup_stays_ignored),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
