/* Workers: an event waits for the least lower bound; tasks are paused, run on, taken back, dropped. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <sched.h>
#include <cmocka.h>
#include "kernel/workers.h"
#include "tests/child.h"

/* A task is the first member of what it computes; run answers as workers_calls.run does. */
struct job {
    struct task task;
    bool (*run)(struct job *j);
    struct workers *ws;
    atomic_bool started, running, open; /* open: a job that waits for that may go on */
    atomic_int runs;
    int order; /* of runs of all jobs */
};

static atomic_int ran; /* jobs, one after the other */

static void *begin_thread(void *ctx)
{
    return ctx;
}

static bool run_job(void *own, struct task *t)
{
    struct job *j = (struct job *)t;
    (void)own;
    j->order = atomic_fetch_add(&ran, 1) + 1;
    atomic_fetch_add(&j->runs, 1);
    atomic_store(&j->running, true);
    atomic_store(&j->started, true);
    bool done = j->run(j);
    atomic_store(&j->running, false);
    return done;
}

static void end_thread(void *own)
{
    (void)own;
}

static atomic_bool hurried;

static void hurry(pthread_t thread)
{
    assert_false(pthread_equal(thread, pthread_self()));
    atomic_store(&hurried, true);
}

static const struct workers_calls CALLS = {NULL, begin_thread, run_job, end_thread, hurry};

static struct workers *begin(unsigned threads, uint64_t shuffle)
{
    atomic_store(&ran, 0);
    struct workers *ws = workers_new(threads, shuffle, &CALLS, NULL);
    assert_non_null(ws);
    return ws;
}

static void end(struct workers *ws)
{
    workers_halt(ws);
    workers_free(ws);
}

static void submit(struct workers *ws, struct job *j, vtime lower_bound, uint32_t address)
{
    j->ws = ws;
    j->task.address = address;
    atomic_store(&j->task.lower_bound, lower_bound);
    workers_submit(ws, &j->task);
}

static void await(atomic_bool *flag)
{
    while (!atomic_load(flag))
        sched_yield();
}

/* As the coordinator that commits earlier events: it leaves the task to a thread, which may sleep. */
static void await_start(struct job *j)
{
    while (!atomic_load(&j->started)) {
        assert_true(workers_allow(j->ws, 0, 0));
        sched_yield();
    }
}

/* As the coordinator that cannot commit anything before it. */
static struct task *take(struct workers *ws)
{
    struct task *t;
    while (!(t = workers_take(ws)))
        workers_advance(ws, VT_NEVER, 0);
    return t;
}

static bool is_done(struct job *j)
{
    (void)j;
    return true;
}

static bool waits(struct job *j)
{
    await(&j->open);
    return true;
}

static bool pauses_thrice(struct job *j)
{
    return atomic_load(&j->runs) > 3;
}

static bool goes_on_until_told(struct job *j)
{
    while (!workers_report(j->ws, &j->task, atomic_load(&j->task.lower_bound)))
        sched_yield();
    return false;
}

/* The only thread has a task that waits, with a late lower bound, and so leaves others to the coordinator. */
static void occupy(struct workers *ws, struct job *j)
{
    *j = (struct job){.run = waits};
    submit(ws, j, 1000, 0);
    await_start(j);
}

/* --- lower bounds --- */

static void an_event_is_allowed_up_to_the_least_lower_bound(void **state)
{
    struct workers *ws = begin(1, 0);
    struct job late = {.run = waits}, early = {.run = waits};
    (void)state;
    assert_true(workers_allow(ws, VT_NEVER - 1, 0));
    submit(ws, &late, 100, 5);
    submit(ws, &early, 50, 7);
    assert_true(workers_allow(ws, 49, 9));
    assert_true(workers_allow(ws, 50, 6));
    assert_true(workers_allow(ws, 50, 7));
    assert_false(workers_allow(ws, 50, 8));
    assert_false(workers_allow(ws, 51, 0));
    atomic_store(&early.open, true), atomic_store(&late.open, true);
    take(ws), take(ws);
    assert_true(workers_allow(ws, 101, 0));
    end(ws);
}

static bool gets_on(struct job *j)
{
    workers_report(j->ws, &j->task, 80);
    return waits(j);
}

static void a_task_that_gets_on_allows_later_events(void **state)
{
    struct workers *ws = begin(1, 0);
    struct job j = {.run = gets_on};
    (void)state;
    submit(ws, &j, 50, 7);
    await_start(&j);
    while (!workers_allow(ws, 80, 7))
        sched_yield();
    assert_false(workers_allow(ws, 80, 8));
    atomic_store(&j.open, true);
    take(ws);
    end(ws);
}

static void the_bound_is_never_later_than_a_tasks_lower_bound(void **state)
{
    enum { JOBS = 20 };
    struct workers *ws = begin(1, 0);
    struct job first, j[JOBS];
    (void)state;
    assert_true(workers_bound(ws) == VT_NEVER);
    occupy(ws, &first);
    vtime least = 1000;
    for (int i = 0; i < JOBS; i++) {
        vtime t = (vtime)(i * 7 % JOBS + 100);
        j[i] = (struct job){.run = is_done};
        submit(ws, &j[i], t, 1);
        least = vt_min(least, t);
        assert_true(workers_bound(ws) <= least);
    }
    atomic_store(&first.open, true);
    for (int i = 0; i <= JOBS; i++)
        take(ws);
    assert_true(workers_bound(ws) == VT_NEVER);
    end(ws);
}

static bool reports_an_earlier_bound(struct job *j)
{
    workers_report(j->ws, &j->task, 60);
    workers_report(j->ws, &j->task, 59);
    return true;
}

static bool reports_the_same_bound(struct job *j)
{
    workers_report(j->ws, &j->task, 60);
    workers_report(j->ws, &j->task, 60);
    return true;
}

static void take_one(void *arg)
{
    struct workers *ws = begin(1, 0);
    submit(ws, arg, 50, 0);
    take(ws);
}

/* Does a process end by abort() that runs such a task? */
static bool aborts(bool (*run)(struct job *j))
{
    struct job j = {.run = run};
    return child_aborts(take_one, &j);
}

static void a_lower_bound_that_goes_back_is_caught(void **state)
{
    (void)state;
    assert_true(aborts(reports_an_earlier_bound));
    assert_false(aborts(reports_the_same_bound));
}

/* --- tasks --- */

static void a_task_that_is_done_holds_events_up_until_it_is_taken_back(void **state)
{
    struct workers *ws = begin(1, 0);
    struct job j = {.run = is_done}, next = {.run = waits};
    (void)state;
    submit(ws, &j, 50, 7);
    submit(ws, &next, 60, 0);
    await_start(&next); /* the only thread is through with the first */
    assert_true(workers_busy(ws));
    assert_true(workers_allow(ws, 50, 7));
    assert_false(workers_allow(ws, 51, 0));
    assert_ptr_equal(workers_take(ws), &j.task);
    assert_true(workers_allow(ws, 51, 0));
    assert_null(workers_take(ws));
    atomic_store(&next.open, true);
    assert_ptr_equal(take(ws), &next.task);
    assert_false(workers_busy(ws));
    end(ws);
}

static void a_coordinator_that_commits_events_wakes_a_thread_for_a_waiting_task(void **state)
{
    struct workers *ws = begin(1, 0);
    struct job j = {.run = is_done};
    (void)state;
    usleep(20000); /* by then the thread sleeps */
    submit(ws, &j, 50, 7);
    await_start(&j);
    assert_ptr_equal(take(ws), &j.task);
    assert_int_equal(workers_stats(ws).away, 1);
    end(ws);
}

static void a_paused_task_is_run_on(void **state)
{
    struct workers *ws = begin(1, 0);
    struct job j = {.run = pauses_thrice};
    (void)state;
    submit(ws, &j, 50, 7);
    assert_ptr_equal(take(ws), &j.task);
    assert_int_equal(j.runs, 4);
    assert_null(workers_take(ws));
    end(ws);
}

static void the_coordinator_helps_with_the_least_task(void **state)
{
    static const struct {
        vtime time;
        uint32_t address;
        int order;
    } JOB[] = {{90, 1, 6}, {30, 2, 3}, {30, 1, 2}, {20, 9, 1}, {70, 0, 5}, {40, 0, 4}};
    enum { JOBS = sizeof JOB / sizeof JOB[0] };
    struct workers *ws = begin(1, 0);
    struct job first, j[JOBS];
    (void)state;
    occupy(ws, &first);
    for (int i = 0; i < JOBS; i++)
        j[i] = (struct job){.run = is_done}, submit(ws, &j[i], JOB[i].time, JOB[i].address);
    for (int i = 0; i < JOBS; i++)
        take(ws);
    for (int i = 0; i < JOBS; i++)
        assert_int_equal(j[i].order - first.order, JOB[i].order);
    assert_int_equal(workers_stats(ws).helped, JOBS);
    atomic_store(&first.open, true);
    assert_ptr_equal(take(ws), &first.task);
    end(ws);
}

static void a_coordinator_that_helps_returns_to_its_events(void **state)
{
    struct workers *ws = begin(1, 0);
    struct job first, j = {.run = goes_on_until_told};
    (void)state;
    occupy(ws, &first);
    submit(ws, &j, 50, 7);
    workers_advance(ws, 100, 0);
    assert_int_equal(j.runs, 1);
    assert_null(workers_take(ws));
    assert_false(workers_allow(ws, 51, 0));
    workers_drop(ws, &j.task);
    atomic_store(&first.open, true);
    take(ws);
    end(ws);
}

/* --- ends --- */

static void a_waiting_task_that_is_dropped_is_never_run(void **state)
{
    struct workers *ws = begin(1, 0);
    struct job first, j[3];
    (void)state;
    occupy(ws, &first);
    for (uint32_t i = 0; i < 3; i++)
        j[i] = (struct job){.run = is_done}, submit(ws, &j[i], 50 + i, 0);
    workers_drop(ws, &j[0].task);
    assert_true(workers_allow(ws, 51, 0));
    assert_false(workers_allow(ws, 52, 0));
    atomic_store(&first.open, true);
    for (int i = 0; i < 3; i++)
        assert_ptr_not_equal(take(ws), &j[0].task);
    assert_int_equal(j[0].runs, 0);
    assert_false(workers_busy(ws));
    end(ws);
}

static void a_running_task_that_is_dropped_has_stopped(void **state)
{
    (void)state;
    for (uint64_t shuffle = 0; shuffle < 5; shuffle++) {
        struct workers *ws = begin(1, shuffle);
        struct job j = {.run = goes_on_until_told};
        submit(ws, &j, 50, 7);
        await_start(&j);
        workers_drop(ws, &j.task);
        assert_false(j.running);
        assert_false(workers_busy(ws));
        assert_null(workers_take(ws));
        int runs = j.runs;
        struct job other = {.run = is_done};
        submit(ws, &other, 60, 0);
        assert_ptr_equal(take(ws), &other.task);
        assert_int_equal(j.runs, runs);
        end(ws);
    }
}

static void a_task_that_is_done_can_be_dropped(void **state)
{
    struct workers *ws = begin(1, 0);
    struct job j = {.run = is_done}, next = {.run = waits};
    (void)state;
    submit(ws, &j, 50, 7);
    submit(ws, &next, 60, 0);
    await_start(&next);
    workers_drop(ws, &j.task);
    assert_null(workers_take(ws));
    atomic_store(&next.open, true);
    assert_ptr_equal(take(ws), &next.task);
    end(ws);
}

static void halt_returns_only_when_nothing_runs(void **state)
{
    enum { JOBS = 8 };
    (void)state;
    for (uint64_t shuffle = 0; shuffle < 5; shuffle++) {
        struct workers *ws = begin(3, shuffle);
        struct job j[JOBS];
        int runs = 0, now = 0;
        for (uint32_t i = 0; i < JOBS; i++)
            j[i] = (struct job){.run = goes_on_until_told}, submit(ws, &j[i], 50 + i, 0);
        await_start(&j[0]);
        workers_halt(ws);
        for (int i = 0; i < JOBS; i++) {
            assert_false(j[i].running);
            runs += j[i].runs;
        }
        usleep(1000);
        for (int i = 0; i < JOBS; i++)
            now += j[i].runs;
        assert_int_equal(now, runs); /* nor does anything begin */
        workers_free(ws);
    }
}

/* --- a machine of nodes that only compute --- */

enum { NODES = 7, SEGMENTS = 300 };

struct fake_node {
    struct job job;
    vtime at, until; /* how far its segment has come, and where it ends */
    uint64_t random;
    bool has_event; /* at `until` */
};

struct fake_machine {
    struct workers *ws;
    struct fake_node node[NODES];
    uint64_t digest;
};

static bool computes(struct job *j)
{
    struct fake_node *n = (struct fake_node *)j;
    while (n->at < n->until) {
        n->at += 1 + (n->until - n->at) / 4;
        if (workers_report(j->ws, &j->task, n->at))
            return false;
    }
    return true;
}

static void begin_segment(struct fake_machine *m, struct fake_node *n)
{
    n->random = n->random * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    n->has_event = false;
    n->at = n->until;
    n->until += 1 + (n->random >> 33) % 1000;
    submit(m->ws, &n->job, n->at, (uint32_t)(n - m->node));
}

/* The earliest event; NULL: none is known. */
static struct fake_node *earliest(struct fake_machine *m)
{
    struct fake_node *n = NULL;
    for (int i = 0; i < NODES; i++)
        if (m->node[i].has_event && (!n || m->node[i].until < n->until))
            n = &m->node[i];
    return n;
}

static void check_bound(struct fake_machine *m)
{
    vtime bound = workers_bound(m->ws);
    for (int i = 0; i < NODES; i++)
        assert_true(m->node[i].has_event || bound <= atomic_load(&m->node[i].job.task.lower_bound));
}

static uint64_t digest_of_run(unsigned threads, uint64_t shuffle)
{
    struct fake_machine m = {.ws = begin(threads, shuffle)};
    struct instant last = {0};
    for (uint32_t i = 0; i < NODES; i++) {
        m.node[i] = (struct fake_node){.job.run = computes, .random = i};
        begin_segment(&m, &m.node[i]);
    }
    for (int events = 0; events < SEGMENTS;) {
        check_bound(&m);
        for (struct task *t; (t = workers_take(m.ws));)
            ((struct fake_node *)t)->has_event = true;
        struct fake_node *n = earliest(&m);
        vtime time = n ? n->until : VT_NEVER;
        uint32_t address = n ? (uint32_t)(n - m.node) : UINT32_MAX;
        if (!workers_allow(m.ws, time, address)) {
            workers_advance(m.ws, time, address);
            continue;
        }
        assert_true(n && !instant_before(time, address, last));
        last = (struct instant){time, address};
        m.digest = (m.digest ^ (time * NODES + address)) * UINT64_C(1099511628211);
        begin_segment(&m, n);
        events++;
    }
    end(m.ws);
    return m.digest;
}

static bool waits_to_be_hurried(struct job *j)
{
    (void)j;
    while (!atomic_load(&hurried))
        sched_yield();
    return true;
}

static void a_thread_that_does_not_come_back_is_hurried(void **state)
{
    (void)state;
    for (int drops = 0; drops < 2; drops++) {
        struct workers *ws = begin(1, 0);
        struct job j = {.run = waits_to_be_hurried};
        atomic_store(&hurried, false);
        submit(ws, &j, 50, 7);
        await_start(&j);
        if (drops)
            workers_drop(ws, &j.task);
        end(ws);
        assert_true(atomic_load(&hurried));
        assert_false(j.running);
    }
}

static void neither_the_number_of_threads_nor_shuffling_changes_the_order_of_events(void **state)
{
    uint64_t digest = digest_of_run(1, 0);
    (void)state;
    for (unsigned threads = 1; threads <= 4; threads++)
        for (uint64_t shuffle = 0; shuffle < 6; shuffle++)
            assert_true(digest_of_run(threads, shuffle) == digest);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_event_is_allowed_up_to_the_least_lower_bound),
        cmocka_unit_test(a_task_that_gets_on_allows_later_events),
        cmocka_unit_test(the_bound_is_never_later_than_a_tasks_lower_bound),
        cmocka_unit_test(a_lower_bound_that_goes_back_is_caught),
        cmocka_unit_test(a_task_that_is_done_holds_events_up_until_it_is_taken_back),
        cmocka_unit_test(a_coordinator_that_commits_events_wakes_a_thread_for_a_waiting_task),
        cmocka_unit_test(a_paused_task_is_run_on),
        cmocka_unit_test(the_coordinator_helps_with_the_least_task),
        cmocka_unit_test(a_coordinator_that_helps_returns_to_its_events),
        cmocka_unit_test(a_waiting_task_that_is_dropped_is_never_run),
        cmocka_unit_test(a_running_task_that_is_dropped_has_stopped),
        cmocka_unit_test(a_task_that_is_done_can_be_dropped),
        cmocka_unit_test(halt_returns_only_when_nothing_runs),
        cmocka_unit_test(a_thread_that_does_not_come_back_is_hurried),
        cmocka_unit_test(neither_the_number_of_threads_nor_shuffling_changes_the_order_of_events),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
