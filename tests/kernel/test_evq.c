/* The order of events: (time, address, sent or ordinary or late, sequence), whatever the order they were put
 * in. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>
#include "kernel/evq.h"

struct log {
    int seen[4096];
    vtime at[4096];
    int count;
};

static void note(void *ctx, void *arg, vtime now)
{
    struct log *log = ctx;
    log->at[log->count] = now;
    log->seen[log->count++] = (int)(intptr_t)arg;
}

static void run(struct evq *q)
{
    while (evq_step(q, &(struct instant){0}, &(struct instant){0}))
        ;
    evq_free(q);
}

static void put(struct evq *q, struct log *log, vtime t, uint32_t address, int id)
{
    evq_put(q, t, address, note, log, (void *)(intptr_t)id);
}

static void earlier_time_comes_first(void **state)
{
    struct log log = {0};
    struct evq *q = evq_new();
    (void)state;
    put(q, &log, 30, 0, 3);
    put(q, &log, 10, 9, 1);
    put(q, &log, 20, 0, 2);
    assert_int_equal(evq_next(q), 10);
    run(q);
    for (int i = 0; i < 3; i++)
        assert_int_equal(log.seen[i], i + 1);
}

static void at_one_time_places_go_in_order_and_at_one_place_sequence_decides(void **state)
{
    struct log log = {0};
    struct evq *q = evq_new();
    (void)state;
    put(q, &log, 5, 2, 3);
    put(q, &log, 5, 1, 1);
    put(q, &log, 5, 2, 4);
    put(q, &log, 5, 1, 2);
    run(q);
    for (int i = 0; i < 4; i++)
        assert_int_equal(log.seen[i], i + 1);
}

static void late_events_come_after_all_others_of_their_time_and_place(void **state)
{
    struct log log = {0};
    struct evq *q = evq_new();
    (void)state;
    evq_put_late(q, 5, 1, note, &log, (void *)2);
    put(q, &log, 5, 1, 1);
    put(q, &log, 5, 2, 3);
    assert_false(evq_late_is_first(q, 5, 1));
    assert_true(evq_late_is_first(q, 5, 0));
    assert_true(evq_late_is_first(q, 4, 7));
    run(q);
    for (int i = 0; i < 3; i++)
        assert_int_equal(log.seen[i], i + 1);
}

enum kind { SENT, ORDINARY, LATE };

static void put_kind(struct evq *q, struct instant at, enum kind kind, struct evq_sender by, evq_fire *fire,
                     void *ctx, int id)
{
    void *arg = (void *)(intptr_t)id;
    if (kind == SENT)
        evq_put_sent(q, at.time, at.address, by, fire, ctx, arg);
    else
        (kind == LATE ? evq_put_late : evq_put)(q, at.time, at.address, fire, ctx, arg);
}

/* What happens in this order at one time and address. */
enum { SENT_AND_OTHERS = 7 }; /* a prime: steps of any width go round all */
static const struct {
    enum kind kind;
    struct evq_sender by;
} sent_and_others[SENT_AND_OTHERS] = {
    {SENT, {2, 7}},
    {SENT, {2, 8}},
    {SENT, {3, 1 << 22}}, /* the low 22 bits count */
    {SENT, {3, (1 << 22) - 1}},
    {SENT, {(1 << 20) - 1, 0}},
    {ORDINARY, {0}},
    {LATE, {0}},
};

/* So many of them, put in from the first on in steps of that width, before what is later. */
static void come_in_order(int events, int first, int width, int later)
{
    struct log log = {0};
    struct evq *q = evq_new();
    for (int i = 0; i < later; i++)
        put(q, &log, 9, 0, SENT_AND_OTHERS + i);
    for (int i = 0; i < events; i++) {
        int id = (first + i * width) % SENT_AND_OTHERS;
        put_kind(q, (struct instant){5, 1}, sent_and_others[id].kind, sent_and_others[id].by, note, &log, id);
    }
    run(q);
    assert_int_equal(log.count, events + later);
    for (int i = 1; i < log.count; i++)
        assert_true(log.seen[i - 1] < log.seen[i]);
}

/* The heap holds all of a few, the lists all that comes after those. */
static void what_is_sent_comes_by_sender_and_number_before_all_else_of_its_time_and_place(void **state)
{
    (void)state;
    for (int events = 1; events <= SENT_AND_OTHERS; events++)
        for (int first = 0; first < SENT_AND_OTHERS; first++)
            for (int width = 1; width < SENT_AND_OTHERS; width++) {
                come_in_order(events, first, width, 0);
                come_in_order(events, first, width, 40);
            }
}

struct turns {
    struct evq *q;
    int taken;
    bool over;
};

static void take_turn_again(void *ctx, void *arg, vtime now)
{
    struct turns *t = ctx;
    if (!t->over && ++t->taken < 10)
        evq_put_late(t->q, now, 1, take_turn_again, t, arg);
}

static void end_turns(void *ctx, void *arg, vtime now)
{
    struct turns *t = ctx;
    (void)arg, (void)now;
    t->over = true;
}

/* One that is put again whenever it happens gives the other its turn, however many others wait. */
static void late_events_of_one_time_and_place_take_turns(void **state)
{
    (void)state;
    for (int others = 0; others < 20; others++) {
        struct log log = {0};
        struct turns t = {.q = evq_new()};
        for (int i = 0; i < others; i++)
            put(t.q, &log, 9, 9, i);
        evq_put_late(t.q, 5, 1, take_turn_again, &t, NULL);
        evq_put_late(t.q, 5, 1, end_turns, &t, NULL);
        run(t.q);
        assert_int_equal(t.taken, 1);
        assert_int_equal(log.count, others);
    }
}

static void thousands_of_events_come_out_sorted(void **state)
{
    struct log log = {0};
    struct evq *q = evq_new();
    uint32_t x = 12345;
    (void)state;
    for (int i = 0; i < 4000; i++) {
        x = x * 1664525u + 1013904223u;
        put(q, &log, x >> 20, x & 7, i);
    }
    run(q);
    assert_int_equal(log.count, 4000);
    for (int i = 1; i < 4000; i++)
        assert_true(log.at[i - 1] <= log.at[i]);
}

static void count(void *ctx, void *arg, vtime now)
{
    (void)arg, (void)now;
    ++*(int *)ctx;
}

/* The ctx of what comes, which is `count`. */
static void *coming(const struct evq *q, unsigned after)
{
    evq_fire *fire;
    void *ctx = evq_coming(q, after, &fire);
    assert_true(fire == (ctx ? count : NULL));
    return ctx;
}

/* Of the events of one time that came in order what comes is known, once it has begun; of others nothing. */
static void of_one_time_what_comes_is_known(void **state)
{
    enum { EVENTS = 60 };
    int happened[EVENTS + 1] = {0};
    struct evq *q = evq_new();
    (void)state;
    for (int i = 0; i < EVENTS; i++)
        evq_put(q, 7, (uint32_t)i, count, &happened[i], NULL);
    evq_put(q, 8, 0, count, &happened[EVENTS], NULL);
    assert_null(coming(q, 5));
    for (int i = 0; i < 10; i++)
        assert_true(evq_step(q, &(struct instant){0}, &(struct instant){0}));
    for (int at = 10; at < EVENTS - 1; at++) {
        for (int after = 0; after <= 22; after++)
            assert_ptr_equal(coming(q, (unsigned)after), at + after < EVENTS ? &happened[at + after] : NULL);
        assert_true(evq_step(q, &(struct instant){0}, &(struct instant){0}));
    }
    evq_free(q);
}

/* --- any mix of puts and steps, beside a plain list --- */

enum { MOST = 3000, RANK_BITS = 42 };

struct plain {
    struct expected {
        vtime time;
        uint64_t rank; /* address, kind, sequence or sender and number */
        int id;
    } pending[MOST];
    int length, next_id, steps;
    struct evq *q;
    uint64_t random;
    int happened; /* the id */
    vtime now;
};

static uint64_t some(struct plain *p, uint64_t below)
{
    p->random = p->random * UINT64_C(6364136223846793005) + 1442695040888963407;
    return (p->random >> 33) % below;
}

static void happens(void *ctx, void *arg, vtime now)
{
    struct plain *p = ctx;
    p->happened = (int)(intptr_t)arg;
    p->now = now;
}

/* How far an event is off: now, at one of a few distances, anywhere near, or far away. */
static vtime distance(struct plain *p)
{
    static const vtime usual[] = {1100000, 5000000, 35000000, 40425000};
    switch (some(p, 8)) {
    case 0:
        return 0;
    case 1:
        return some(p, 100);
    case 2:
        return some(p, 1 << 30);
    case 3:
        return some(p, 1 << 10) << some(p, 50);
    default:
        return usual[some(p, 4)];
    }
}

static void put_any(struct plain *p)
{
    vtime time = p->now + distance(p);
    uint32_t address = (uint32_t)(some(p, 8) ? (uint64_t)p->next_id % 64 : some(p, 64));
    enum kind kind = (enum kind[]){SENT, ORDINARY, ORDINARY, LATE}[some(p, 4)];
    int id = p->next_id++;
    struct evq_sender by = {(uint32_t)some(p, 4), (1 << 22) - 500 + (uint64_t)id};
    uint64_t sequence = kind == SENT ? (uint64_t)by.address << 22 | by.number % (1 << 22) : (uint64_t)id;
    p->pending[p->length++] =
        (struct expected){time, (4 * (uint64_t)address + kind) << RANK_BITS | sequence, id};
    put_kind(p->q, (struct instant){time, address}, kind, by, happens, p, id);
}

static uint32_t place_of(const struct expected *e)
{
    return (uint32_t)(e->rank >> (RANK_BITS + 2));
}

static int first_of(const struct plain *p)
{
    int first = 0;
    for (int i = 1; i < p->length; i++) {
        const struct expected *a = &p->pending[i], *b = &p->pending[first];
        if (a->time < b->time || (a->time == b->time && a->rank < b->rank))
            first = i;
    }
    return first;
}

static void step_as_expected(struct plain *p)
{
    struct expected *e = &p->pending[first_of(p)];
    assert_int_equal(evq_next(p->q), e->time);
    assert_int_equal(evq_next_address(p->q), place_of(e));
    assert_false(evq_late_is_first(p->q, e->time, place_of(e)));
    assert_int_equal(evq_late_is_first(p->q, e->time, 0), place_of(e) > 0);
    evq_fire *fire;
    const void *hint = evq_coming(p->q, 0, &fire);
    assert_true(fire == (hint ? happens : NULL));
    assert_true(evq_step(p->q, &(struct instant){0}, &(struct instant){0}));
    assert_int_equal(p->happened, e->id);
    assert_int_equal(p->now, e->time);
    *e = p->pending[--p->length];
}

static void any_mix_comes_out_in_order(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 40; seed++) {
        struct plain *p = calloc(1, sizeof *p);
        p->q = evq_new();
        p->random = seed;
        for (int phase = 0; phase < 20; phase++) {
            uint64_t puts = some(p, 9); /* of 8: it grows, shrinks, empties */
            for (int i = 0; i < 150; i++)
                if (some(p, 8) < puts)
                    put_any(p);
                else if (p->length > 0)
                    step_as_expected(p);
        }
        while (p->length > 0)
            step_as_expected(p);
        assert_false(evq_step(p->q, &(struct instant){0}, &(struct instant){0}));
        assert_int_equal(evq_next(p->q), VT_NEVER);
        assert_int_equal(evq_next_address(p->q), UINT32_MAX);
        assert_true(evq_late_is_first(p->q, VT_NEVER, 0));
        evq_free(p->q);
        free(p);
    }
}

static void the_end_of_time_can_be_reached(void **state)
{
    struct log log = {0};
    struct evq *q = evq_new();
    (void)state;
    put(q, &log, VT_NEVER, 1, 4);
    put(q, &log, VT_NEVER - 1, 2, 3);
    put(q, &log, 0, 3, 1);
    put(q, &log, UINT64_C(1) << 63, 4, 2);
    run(q);
    assert_int_equal(log.count, 4);
    for (int i = 0; i < 4; i++)
        assert_int_equal(log.seen[i], i + 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(earlier_time_comes_first),
        cmocka_unit_test(at_one_time_places_go_in_order_and_at_one_place_sequence_decides),
        cmocka_unit_test(late_events_come_after_all_others_of_their_time_and_place),
        cmocka_unit_test(what_is_sent_comes_by_sender_and_number_before_all_else_of_its_time_and_place),
        cmocka_unit_test(late_events_of_one_time_and_place_take_turns),
        cmocka_unit_test(thousands_of_events_come_out_sorted),
        cmocka_unit_test(of_one_time_what_comes_is_known),
        cmocka_unit_test(any_mix_comes_out_in_order),
        cmocka_unit_test(the_end_of_time_can_be_reached),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
