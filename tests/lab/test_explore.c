/* test_explore.c - what touchstone explore takes from recordings, against brute force on random ones: which
 * event happens before which, what other orders there could have been, which runs are of one order; and delta
 * debugging, against all subsets. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "kernel/xalloc.h"
#include "lab/explore/delta.h"
#include "lab/explore/digest_set.h"
#include "lab/explore/divergence.h"
#include "lab/explore/flips.h"
#include "lab/explore/guarantee.h"
#include "lab/jobs/line_changes.h"
#include "lab/explore/race_flips.h"
#include "lab/explore/run_verdict.h"

static uint64_t seed = 1;

static uint32_t below(uint32_t most)
{
    seed = seed * UINT64_C(6364136223846793005) + 1442695040888963407;
    return (uint32_t)(seed >> 33) % most;
}

/* --- random recordings ---------------------------------------------------------------------------------- */

enum { NODES = 4, STEPS = 40, US = 1000000 };

/* Messages of two types between nodes, whose receives select any type or one; some take longer. */
struct made {
    int count;
    struct {
        uint32_t from, to, number, index, type;
        uint64_t sent, came;
        bool taken;
    } message[STEPS];
    uint64_t clock[NODES];
    uint32_t sends[NODES], receives[NODES], pairs[NODES][NODES];
    FILE *out;
};

static void make_send(struct made *m, uint32_t node)
{
    uint32_t to = (node + 1 + below(NODES - 1)) % NODES;
    m->message[m->count].from = node, m->message[m->count].to = to;
    m->message[m->count].number = m->pairs[node][to]++;
    m->message[m->count].index = m->sends[node]++;
    m->message[m->count].type = below(2);
    m->message[m->count].sent = m->clock[node];
    m->message[m->count].came = m->clock[node] + (1 + below(60)) * US;
    m->count++;
    m->clock[node] += (1 + below(9)) * US;
}

/* The message that came first of those that the receive selects; -1: none. */
static int first_come(const struct made *m, uint32_t node, int64_t typesel)
{
    int best = -1;
    for (int i = 0; i < m->count; i++)
        if (m->message[i].to == node && !m->message[i].taken &&
            (typesel == -1 || m->message[i].type == typesel) &&
            (best < 0 || m->message[i].came < m->message[best].came))
            best = i;
    return best;
}

static void make_receive(struct made *m, uint32_t node)
{
    int64_t typesel = below(3) ? -1 : (int64_t)below(2);
    int i = first_come(m, node, typesel);
    if (i < 0)
        return;
    uint64_t posted = m->clock[node], at = posted > m->message[i].came ? posted : m->message[i].came;
    m->message[i].taken = true;
    fprintf(m->out,
            "match %u %u %u %u i=%u posted=%" PRIu64 " at=%" PRIu64 " sent=%" PRIu64 " came=%" PRIu64
            " type=%u typesel=%" PRId64 " sel=-1 call=crecv line=a.c:%u\n",
            node, m->receives[node]++, m->message[i].from, m->message[i].number, m->message[i].index, posted,
            at, m->message[i].sent, m->message[i].came, m->message[i].type, typesel, below(5));
    m->clock[node] = at + US;
}

static struct recording *read_text(char *text)
{
    char *error = NULL;
    FILE *in = fmemopen(text, strlen(text), "r");
    struct recording *r = recording_read(in, "made", &error);
    fclose(in);
    if (!r)
        fail_msg("%s", error);
    return r;
}

static struct recording *made_recording(void)
{
    struct made m = {0};
    char *text = NULL;
    size_t size;
    m.out = open_memstream(&text, &size);
    fprintf(m.out, "touchstone-schedule 1\nnodes %d\n", NODES);
    for (int step = 0; step < STEPS; step++)
        if (below(2))
            make_send(&m, below(NODES));
        else
            make_receive(&m, below(NODES));
    for (int i = 0; i < m.count; i++)
        if (!m.message[i].taken)
            fprintf(m.out, "left %u %u %u i=%u sent=%" PRIu64 " came=%" PRIu64 " type=%u\n", m.message[i].to,
                    m.message[i].from, m.message[i].number, m.message[i].index, m.message[i].sent,
                    m.message[i].came, m.message[i].type);
    fclose(m.out);
    struct recording *r = read_text(text);
    free(text);
    return r;
}

/* --- happens before ------------------------------------------------------------------------------------- */

/* Does receive a happen before receive b, by the definition: on one node the earlier one; or a message of a
 * node, sent behind it, is received by it or before it? */
static bool before(const struct recording *r, size_t a, size_t b);

static bool before_sending(const struct recording *r, size_t a, const struct rec_message *m)
{
    for (size_t i = 0; i < r->receive_count; i++)
        if (r->receives[i].node == m->from && r->receives[i].at <= m->sent && (i == a || before(r, a, i)))
            return true;
    return false;
}

static bool before(const struct recording *r, size_t a, size_t b)
{
    const struct rec_receive *x = &r->receives[a], *y = &r->receives[b];
    if (x->at >= y->at)
        return false;
    if (x->node == y->node)
        return true;
    for (size_t i = 0; i < r->receive_count;
         i++) /* of y's node, up to y: each orders what sent its message */
        if (r->receives[i].node == y->node && r->receives[i].number <= y->number &&
            before_sending(r, a, &r->messages[r->receives[i].message]))
            return true;
    return false;
}

static void clocks_tell_what_happens_before(void **state)
{
    (void)state;
    size_t yes = 0, no = 0;
    for (int round = 0; round < 60; round++) {
        struct recording *r = made_recording();
        struct event_rows t = event_rows_of(r);
        struct clocks c = clocks_of(r, &t, 1 << 20);
        for (size_t a = 0; a < r->receive_count; a++)
            for (size_t m = 0; m < r->message_count; m++) {
                bool is = before_sending(r, a, &r->messages[m]);
                assert_int_equal(clocks_before_sending(&c, &t.events[t.of_receive[a]], &r->messages[m]), is);
                yes += is, no += !is;
            }
        clocks_free(&c);
        event_rows_free(&t);
        recording_free(r);
    }
    assert_true(yes > 1000 && no > 1000);
}

static void without_room_for_clocks_time_decides(void **state)
{
    (void)state;
    struct recording *r = made_recording();
    struct event_rows t = event_rows_of(r);
    struct clocks c = clocks_of(r, &t, 3);
    assert_null(c.after);
    for (size_t a = 0; a < r->receive_count; a++)
        for (size_t m = 0; m < r->message_count; m++)
            if (before_sending(r, a, &r->messages[m]))
                assert_true(clocks_before_sending(&c, &t.events[t.of_receive[a]], &r->messages[m]));
    event_rows_free(&t);
    recording_free(r);
}

/* --- orders --------------------------------------------------------------------------------------------- */

/* The causal past of a receive, itself included, as a set of receives. */
static void add_past(const struct recording *r, size_t b, bool *past)
{
    const struct rec_receive *v = &r->receives[b];
    const struct rec_message *m = &r->messages[v->message];
    if (past[b])
        return;
    past[b] = true;
    for (size_t i = 0; i < r->receive_count; i++)
        if ((r->receives[i].node == v->node && r->receives[i].number < v->number) ||
            (r->receives[i].node == m->from && r->receives[i].at <= m->sent))
            add_past(r, i, past);
}

/* So many receives its sender had made before it sent the message. */
static int known_when_sent(const struct recording *r, const struct rec_message *m)
{
    int count = 0;
    for (size_t i = 0; i < r->receive_count; i++)
        count += r->receives[i].node == m->from && r->receives[i].at <= m->sent;
    return count;
}

/* The past as a text: what each node's receives got, and where in its program the sender sent it. */
static void past_text(const struct recording *r, size_t b, char *text)
{
    bool past[STEPS] = {0};
    add_past(r, b, past);
    text += sprintf(text, "%u.%" PRIu64 ":", r->receives[b].node, r->receives[b].number);
    for (size_t i = 0; i < r->receive_count; i++)
        if (past[i])
            text += sprintf(text, "%u.%" PRIu64 "<%u.%" PRIu64 "@%d ", r->receives[i].node,
                            r->receives[i].number, r->receives[i].from, r->receives[i].from_number,
                            known_when_sent(r, &r->messages[r->receives[i].message]));
}

static void equal_digests_are_equal_pasts(void **state)
{
    (void)state;
    enum { MOST = 4000, LENGTH = 512 };
    char(*texts)[LENGTH] = xcalloc(MOST, LENGTH);
    struct digest *digests = xcalloc(MOST, sizeof *digests);
    size_t count = 0, equal = 0;
    for (int round = 0; round < 150; round++) {
        struct recording *r = made_recording();
        struct event_rows t = event_rows_of(r);
        struct order o = order_of(r, &t);
        for (size_t i = 0; i < r->receive_count && count < MOST; i++, count++) {
            past_text(r, i, texts[count]);
            digests[count] = o.event[t.of_receive[i]];
        }
        order_free(&o);
        event_rows_free(&t);
        recording_free(r);
    }
    for (size_t a = 0; a < count; a++)
        for (size_t b = 0; b < a; b++) {
            bool same = !strcmp(texts[a], texts[b]);
            equal += same;
            assert_int_equal(digest_equal(digests[a], digests[b]), same);
        }
    assert_true(count > 1000 && equal > 100);
    free(texts);
    free(digests);
}

static void times_do_not_make_another_order(void **state)
{
    (void)state;
    char one[] = "touchstone-schedule 1\nnodes 3\nmatch 0 0 1 0 at=5 posted=1 sent=2 came=5\n"
                 "match 2 0 1 0 at=7\nhandler 2 0 4 at=9\n";
    char other[] = "touchstone-schedule 1\nnodes 3\nspeed 1 200\nhandler 2 0 4 at=4\nmatch 2 0 1 0 at=3\n"
                   "match 0 0 1 0 at=50 posted=1 sent=2 came=5\n";
    char unlike[] = "touchstone-schedule 1\nnodes 3\nmatch 0 0 2 0 at=5 posted=1 sent=2 came=5\n"
                    "match 2 0 1 0 at=7\nhandler 2 0 4 at=9\n";
    char late[] = "touchstone-schedule 1\nnodes 3\nmatch 0 0 1 0 at=5 posted=1 sent=2 came=5\n"
                  "match 2 0 1 0 at=7\nhandler 2 0 5 at=9\n";
    struct recording *a = read_text(one), *b = read_text(other), *c = read_text(unlike), *d = read_text(late);
    assert_true(digest_equal(order_of_run(a), order_of_run(b)));
    assert_false(digest_equal(order_of_run(a), order_of_run(c)));
    assert_false(digest_equal(order_of_run(a), order_of_run(d)));
    recording_free(a);
    recording_free(b);
    recording_free(c);
    recording_free(d);
}

/* --- flips ---------------------------------------------------------------------------------------------- */

static const struct delay_bounds BOUNDS = {{0, 10 * US, 20 * US, 5 * US}};

/* By the definition: another sender's first message that came later, is selected, not got before, not ordered
 * behind the receive, and within the bounds. */
static bool could_have_got(const struct recording *r, size_t receive, size_t message)
{
    const struct rec_receive *v = &r->receives[receive];
    const struct rec_message *m = &r->messages[message], *won = &r->messages[v->message];
    if (m->to != v->node || m->from == v->from || (v->typesel != -1 && v->typesel != m->type))
        return false;
    if (m->taken != REC_NONE && r->receives[m->taken].number <= v->number)
        return false;
    return m->came >= won->came && m->came - won->came < 30 * US && !before_sending(r, receive, m);
}

/* Of one sender only the one that came first. */
static bool is_first_of_sender(const struct recording *r, size_t receive, size_t message)
{
    for (size_t i = 0; i < r->message_count; i++)
        if (i != message && r->messages[i].from == r->messages[message].from &&
            could_have_got(r, receive, i) &&
            (r->messages[i].came < r->messages[message].came ||
             (r->messages[i].came == r->messages[message].came && i < message)))
            return false;
    return true;
}

static void flips_are_all_candidates(void **state)
{
    (void)state;
    size_t all = 0;
    for (int round = 0; round < 80; round++) {
        struct recording *r = made_recording();
        struct event_rows t = event_rows_of(r);
        struct order o = order_of(r, &t);
        struct clocks c = clocks_of(r, &t, 1 << 20);
        struct flips f = flips_of(&o, &c, &BOUNDS);
        size_t expected = 0;
        for (size_t v = 0; v < r->receive_count; v++)
            for (size_t m = 0; m < r->message_count; m++) {
                if (!could_have_got(r, v, m) || !is_first_of_sender(r, v, m))
                    continue;
                struct digest order = order_with(&o, &r->receives[v], &r->messages[m]);
                size_t found = 0;
                for (size_t i = 0; i < f.count; i++)
                    found += digest_equal(f.list[i].order, order) && f.list[i].node == r->receives[v].node;
                assert_int_equal(found, 1);
                expected++;
            }
        assert_int_equal(f.count, expected);
        all += expected;
        free(f.list);
        clocks_free(&c);
        order_free(&o);
        event_rows_free(&t);
        recording_free(r);
    }
    assert_true(all > 200);
}

static void a_flip_keeps_to_the_bounds(void **state)
{
    (void)state;
    struct flip f = {.node = 1, .from = 2, .index = 7, .later = 24 * US};
    struct delays d = {0};
    assert_true(flip_delay(&f, 1 * US, &BOUNDS, &d));
    assert_int_equal(delays_value(&d, DELAY_MESSAGE, 2, 7), 20 * US);
    assert_int_equal(delays_value(&d, DELAY_START, 2, 0), 5 * US);
    assert_false(flip_delay(&f, 1 * US, &BOUNDS, &d));
    assert_int_equal(delays_value(&d, DELAY_MESSAGE, 2, 7), 20 * US);
    assert_int_equal(delays_value(&d, DELAY_START, 2, 0), 10 * US);
    delays_free(&d);
}

static void a_wanted_interrupt_comes_at_its_time(void **state)
{
    (void)state;
    char text[] = "touchstone-schedule 1\nnodes 2\nhandler 1 0 3 at=1000 due=900\nhandler 1 1 5 at=2000\n";
    struct recording *r = read_text(text);
    struct event_rows t = event_rows_of(r);
    struct order o = order_of(r, &t);
    struct flips f = {0};
    struct delays d = {0};
    assert_true(flips_add_wanted(&f, &o, &BOUNDS, &(struct wanted_interrupt){1, 1, 2500}));
    assert_int_equal(f.count, 1);
    assert_true(flip_delay(&f.list[0], 7, &BOUNDS, &d));
    assert_int_equal(delays_value(&d, DELAY_INTERRUPT, 1, 1), 507);
    assert_false(flips_add_wanted(&f, &o, &BOUNDS, &(struct wanted_interrupt){1, 1, 1500}));
    assert_false(flips_add_wanted(&f, &o, &BOUNDS, &(struct wanted_interrupt){1, 2, 1500}));
    assert_false(flips_add_wanted(&f, &o, &BOUNDS, &(struct wanted_interrupt){1, 0, 1000 + 6 * US}));
    assert_int_equal(f.count, 1);
    free(f.list);
    delays_free(&d);
    order_free(&o);
    event_rows_free(&t);
    recording_free(r);
}

/* What a run's figures say of races (run --json of a program built by nxcc --races). */
static void a_race_wants_the_handler_behind_the_other_access(void **state)
{
    (void)state;
    char text[] =
        "touchstone-schedule 1\nnodes 2\nhandler 1 0 3 at=1000000 due=900\nhandler 1 1 5 at=2000000\n";
    struct recording *r = read_text(text);
    struct event_rows t = event_rows_of(r);
    struct order o = order_of(r, &t);
    struct flips f = {0};
    json_t *races =
        json_loads("[{\"first_on\": \"node 1\", \"accesses\": [{\"in\": \"main\", \"at_s\": 0.000004},"
                   "{\"in\": \"handler\", \"at_s\": 0.0000025}]},"
                   "{\"first_on\": \"node 1\", \"accesses\": [{\"in\": \"main\", \"at_s\": 0.000001},"
                   "{\"in\": \"handler\", \"at_s\": 0.0000025}]},"
                   "{\"first_on\": \"node 1\", \"accesses\": [{\"in\": \"main\"}, {\"in\": \"main\"}]}]",
                   0, NULL);
    race_flips_add(&f, &o, &BOUNDS, races);
    assert_int_equal(f.count, 1);
    assert_int_equal(f.list[0].number, 1);
    assert_int_equal(f.list[0].later, 2 * US);
    json_decref(races);
    free(f.list);
    order_free(&o);
    event_rows_free(&t);
    recording_free(r);
}

static void a_handler_may_run_behind_what_comes_next(void **state)
{
    (void)state;
    char text[] = "touchstone-schedule 1\nnodes 2\nhandler 1 0 3 at=1000000\n"
                  "match 1 0 0 0 i=0 posted=3000000 at=4000000 sent=1 came=2\n"
                  "match 1 1 0 1 i=1 posted=9000000 at=9000000 sent=1 came=2\n";
    struct recording *r = read_text(text);
    struct event_rows t = event_rows_of(r);
    struct order o = order_of(r, &t);
    struct clocks c = clocks_of(r, &t, 1000);
    struct flips f = flips_of(&o, &c, &BOUNDS);
    assert_int_equal(f.count, 8); /* the second is beyond the bound of 5 us; and 7 moments before the first */
    assert_true(f.list[0].handler);
    assert_int_equal(f.list[0].later, 2 * US);
    for (size_t i = 1; i < f.count; i++)
        assert_int_equal(f.list[i].later, 2 * US * i / 8);
    free(f.list);
    clocks_free(&c);
    order_free(&o);
    event_rows_free(&t);
    recording_free(r);
}

/* --- delta debugging ------------------------------------------------------------------------------------ */

/* What shows, by subset of at most 6 items. */
struct table {
    bool shows[64];
    size_t count, tests;
};

static unsigned as_number(const unsigned char *kept, size_t count)
{
    unsigned set = 0;
    for (size_t i = 0; i < count; i++)
        set |= (unsigned)kept[i] << i;
    return set;
}

static bool look_up(void *arg, unsigned char *const kept[], size_t parts, bool shows[])
{
    struct table *t = arg;
    for (size_t i = 0; i < parts; i++)
        shows[i] = t->shows[as_number(kept[i], t->count)];
    t->tests += parts;
    return true;
}

static void the_least_is_1_minimal(void **state)
{
    (void)state;
    for (int round = 0; round < 2000; round++) {
        struct table t = {.count = 1 + below(6)};
        unsigned all = (1u << t.count) - 1;
        for (unsigned set = 0; set <= all; set++)
            t.shows[set] = set == all || below(4) == 0;
        unsigned char kept[6];
        assert_true(delta_least(kept, t.count, 1000, look_up, &t));
        unsigned set = as_number(kept, t.count);
        assert_true(t.shows[set]);
        if (t.shows[0])
            assert_int_equal(set, 0);
        for (size_t i = 0; i < t.count; i++)
            assert_false(set >> i & 1 && t.shows[set & ~(1u << i)]);
    }
}

struct needed {
    size_t first, second, count, tests;
};

static bool has_both(void *arg, unsigned char *const kept[], size_t parts, bool shows[])
{
    struct needed *n = arg;
    for (size_t i = 0; i < parts; i++)
        shows[i] = kept[i][n->first] && kept[i][n->second];
    n->tests += parts;
    return true;
}

static void two_of_a_thousand_are_found_by_few_tests(void **state)
{
    (void)state;
    unsigned char *kept = xcalloc(1000, 1);
    for (int round = 0; round < 20; round++) {
        struct needed n = {.first = below(1000), .second = below(1000), .count = 1000};
        assert_true(delta_least(kept, n.count, 1000, has_both, &n));
        for (size_t i = 0; i < n.count; i++)
            assert_int_equal(kept[i], i == n.first || i == n.second);
        assert_true(n.tests < 200);
    }
    struct needed n = {.first = 3, .second = 900, .count = 1000};
    assert_false(delta_least(kept, n.count, 5, has_both, &n));
    assert_true(n.tests <= 5 && kept[3] && kept[900]);
    free(kept);
}

/* --- verdicts ------------------------------------------------------------------------------------------- */

/* A text in the record of a run with these figures and this output. */
static char *recorded(const struct verdict_rules *rules, const char *end, const char *message,
                      const char *out, const char *key)
{
    char path[] = "/tmp/test_explore.XXXXXX", *text = NULL;
    int fd = mkstemp(path);
    FILE *f = fdopen(fd, "w");
    json_t *run = json_pack("{s:s, s:f, s:[], s:s*}", "outcome", end, "virtual_time_s", 1.0, "host_files",
                            "message", message);
    json_dumpf(run, f, 0);
    fclose(f);
    json_decref(run);
    json_t *record = verdict_of(rules, out, path, NULL);
    assert_non_null(record);
    text = xstrdup(json_string_value(json_object_get(record, key)));
    json_decref(record);
    unlink(path);
    return text;
}

static void check_group(const struct verdict_rules *rules, const char *const one[3],
                        const char *const other[3], bool same)
{
    char *a = recorded(rules, one[0], one[1], one[2], "group"),
         *b = recorded(rules, other[0], other[1], other[2], "group");
    assert_int_equal(!strcmp(a, b), same);
    free(a);
    free(b);
}

static void what_is_shown_ends_between_characters(void **state)
{
    char out[8192] = "", *shown;
    const struct verdict_rules all = {0};
    (void)state;
    memset(out, 'x', 4095);
    strcpy(out + 4095, "\u00fc and more");
    shown = recorded(&all, "ended", NULL, out, "shown");
    assert_int_equal(strlen(shown), 4095);
    free(shown);
    shown = recorded(&all, "ended", NULL, "gr\xfcn\n", "shown");
    assert_string_equal(shown, "gr?n\n");
    free(shown);
}

static void runs_are_the_same_by_what_counts(void **state)
{
    (void)state;
    regex_t sums;
    assert_int_equal(regcomp(&sums, "^sum", REG_EXTENDED | REG_NOSUB), 0);
    const struct verdict_rules all = {0}, ordered = {.ordered = true}, same = {.same = &sums};
    const char *const ab[] = {"ended", NULL, "sum 1\nb\n"}, *const ba[] = {"ended", NULL, "b\nsum 1\n"};
    const char *const b2[] = {"ended", NULL, "sum 1\nc\n"}, *const twice[] = {"ended", NULL,
                                                                              "sum 1\nsum 1\nb\n"};
    check_group(&all, ab, ba, true);
    check_group(&ordered, ab, ba, false);
    check_group(&all, ab, b2, false);
    check_group(&same, ab, b2, true);
    check_group(&same, ab, twice, false);
    const char *const d1[] = {"deadlock",
                              "deadlock: every program waits\n  node 0: crecv(2) since 0.1 s (d.c:3)", ""};
    const char *const d2[] = {"deadlock",
                              "deadlock: every program waits\n  nodes 1-3: crecv(2) since 0.7 s (d.c:3)\n"
                              "    1 message is here, sent at e.c:9",
                              "x\n"};
    const char *const d3[] = {"deadlock",
                              "deadlock: every program waits\n  node 0: crecv(2) since 0.1 s (d.c:4)", ""};
    check_group(&all, d1, d2, true);
    check_group(&all, d1, d3, false);
    const char *const c1[] = {"failed", "node 1: killed by SIGSEGV at 0x7f12ab at 0.5 s in main (d.c:7)", ""};
    const char *const c2[] = {"failed", "node 3: killed by SIGSEGV at 0x7eddab at 75.5 us in main (d.c:7)",
                              ""};
    const char *const c3[] = {"failed", "node 3: killed by SIGFPE at 0.75 s in main (d.c:7)", ""};
    check_group(&all, c1, c2, true);
    check_group(&all, c1, c3, false);
    regfree(&sums);
}

/* --- the rest ------------------------------------------------------------------------------------------- */

static void the_first_difference_is_found(void **state)
{
    (void)state;
    char one[] = "touchstone-schedule 1\nnodes 3\n"
                 "match 0 0 1 0 at=1000000 sent=500000 type=7 call=crecv line=a.c:4 from=a.c:9\n"
                 "match 0 1 2 0 at=2000000 sent=500000 type=7 call=crecv line=a.c:5\n";
    char other[] = "touchstone-schedule 1\nnodes 3\n"
                   "match 0 0 2 0 at=1100000 sent=500000 type=7 call=crecv line=a.c:4\n"
                   "match 0 1 1 0 at=2000000 sent=500000 type=7 call=crecv line=a.c:5\n";
    struct recording *a = read_text(one), *b = read_text(other);
    struct divergence d = divergence_first(a, b), none = divergence_first(a, a);
    assert_int_equal(d.kind, DIVERGENCE_MESSAGE);
    assert_int_equal(none.kind, DIVERGENCE_NONE);
    char *words = divergence_words(&d, a, b);
    assert_string_equal(words,
                        "at 1.1 us the 1st receive of node 0 (crecv, a.c:4) got the 1st message of node 2 to "
                        "node 0 (type 7, sent at 500 ns); in the usual timing it got the 1st message of "
                        "node 1 to node 0 (type 7, sent at 500 ns, a.c:9)");
    free(words);
    recording_free(a);
    recording_free(b);
}

static void a_handler_behind_another_call_is_told(void **state)
{
    (void)state;
    char one[] = "touchstone-schedule 1\nnodes 2\nhandler 1 0 6 at=2000000 line=a.c:4\n";
    char other[] = "touchstone-schedule 1\nnodes 2\nhandler 1 0 0 at=1500000 line=a.c:4\n";
    struct recording *a = read_text(one), *b = read_text(other);
    struct divergence d = divergence_first(a, b);
    char *words = divergence_words(&d, a, b);
    assert_string_equal(words,
                        "at 1.5 us the 1st handler of node 1 (a.c:4) ran before the program's first call; in "
                        "the usual timing in or after the program's 6th call");
    free(words);
    recording_free(a);
    recording_free(b);
}

static void a_handler_at_another_moment_is_told(void **state)
{
    (void)state;
    char one[] =
        "touchstone-schedule 1\nnodes 2\nhandler 1 0 3 at=1000000 line=a.c:4\nhandler 1 1 5 at=2000000\n";
    char other[] =
        "touchstone-schedule 1\nnodes 2\nhandler 1 0 3 at=1500000 line=a.c:6\nhandler 1 1 5 at=2100000\n";
    struct recording *a = read_text(one), *b = read_text(other);
    struct divergence d = divergence_first(a, b);
    assert_int_equal(d.kind, DIVERGENCE_MOMENT);
    char *words = divergence_words(&d, a, b);
    assert_string_equal(words, "after the same call, but at another moment: the 1st handler of node 1 ran at "
                               "1.5 us (a.c:6); in the usual timing at 1 us (a.c:4)");
    free(words);
    recording_free(a);
    recording_free(b);
}

static void schedules_are_read_as_they_are_written(void **state)
{
    (void)state;
    struct delays d = {0};
    delays_add(&d, DELAY_MESSAGE, 1, 17, 45 * US);
    delays_add(&d, DELAY_SPEED, 3, 0, 20000);
    delays_add(&d, DELAY_MESSAGE, 1, 17, 5 * US);
    char *text = delays_text(&d, 3, "# why\n");
    assert_string_equal(text,
                        "touchstone-schedule 1\n# why\nnodes 3\nmessage 1 17 50000000\nspeed host 20000\n");
    struct recording *r = read_text(text);
    assert_int_equal(r->nodes, 3);
    assert_int_equal(r->delays.count, 2);
    assert_int_equal(delays_value(&r->delays, DELAY_SPEED, 3, 0), 20000);
    recording_free(r);
    free(text);
    delays_free(&d);
}

static void what_is_wrong_in_a_schedule_is_named(void **state)
{
    (void)state;
    static const char *const texts[][2] = {
        {"nodes 3\n", "f:1: this is no schedule: it does not begin with touchstone-schedule"},
        {"touchstone-schedule 1\nnodes 3\nmatch 1 2\n", "f:3: too few words"},
        {"touchstone-schedule 1\nnodes 3\nmatch 4 2 1 1\n", "f:3: not a node or a count from 0 up"}};
    for (size_t i = 0; i < 3; i++) {
        char *error = NULL;
        FILE *in = fmemopen((char *)(uintptr_t)texts[i][0], strlen(texts[i][0]), "r");
        assert_null(recording_read(in, "f", &error));
        assert_string_equal(error, texts[i][1]);
        fclose(in);
        free(error);
    }
}

static void guarantees_are_those_of_pct(void **state)
{
    (void)state;
    assert_float_equal(guarantee_of_a_run(4, 10, 3), 1.0 / 400, 1e-12);
    assert_true(guarantee_runs(4, 10, 1) == 11); /* 0.75^11 = 0.042, 0.75^10 = 0.056 */
    assert_true(guarantee_runs(1, 10, 1) == 1);
}

static void changed_lines_are_those_that_differ(void **state)
{
    (void)state;
    char *change = line_changes("a\nb\nb\n", "b\na\nc\n"), *order = line_changes("a\nb\n", "b\na\n");
    assert_string_equal(change, "- b\n+ c\n");
    assert_string_equal(order, "the lines shown are the same, in another order\n");
    free(change);
    free(order);
}

static void a_set_of_digests_has_what_was_added(void **state)
{
    (void)state;
    struct digest_set s = {0};
    for (int i = 0; i < 1000; i++)
        assert_true(digest_set_add(&s, digest_of(&i, sizeof i)));
    for (int i = 0; i < 2000; i++)
        assert_int_equal(digest_set_has(&s, digest_of(&i, sizeof i)), i < 1000);
    int again = 5;
    assert_false(digest_set_add(&s, digest_of(&again, sizeof again)));
    digest_set_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clocks_tell_what_happens_before),
        cmocka_unit_test(without_room_for_clocks_time_decides),
        cmocka_unit_test(equal_digests_are_equal_pasts),
        cmocka_unit_test(times_do_not_make_another_order),
        cmocka_unit_test(flips_are_all_candidates),
        cmocka_unit_test(a_flip_keeps_to_the_bounds),
        cmocka_unit_test(a_wanted_interrupt_comes_at_its_time),
        cmocka_unit_test(a_race_wants_the_handler_behind_the_other_access),
        cmocka_unit_test(a_handler_may_run_behind_what_comes_next),
        cmocka_unit_test(the_least_is_1_minimal),
        cmocka_unit_test(two_of_a_thousand_are_found_by_few_tests),
        cmocka_unit_test(what_is_shown_ends_between_characters),
        cmocka_unit_test(runs_are_the_same_by_what_counts),
        cmocka_unit_test(the_first_difference_is_found),
        cmocka_unit_test(a_handler_behind_another_call_is_told),
        cmocka_unit_test(a_handler_at_another_moment_is_told),
        cmocka_unit_test(schedules_are_read_as_they_are_written),
        cmocka_unit_test(what_is_wrong_in_a_schedule_is_named),
        cmocka_unit_test(guarantees_are_those_of_pct),
        cmocka_unit_test(changed_lines_are_those_that_differ),
        cmocka_unit_test(a_set_of_digests_has_what_was_added),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
