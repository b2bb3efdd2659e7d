/* Safra's algorithm: random programs on a ring of processes. It is never wrong, and it is not late. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>
#include "nx_api/mpi/safra.c"

enum { MOST = 9, MOST_UNDER_WAY = 40 };

struct world {
    struct safra process[MOST];
    bool rests[MOST];
    uint32_t count;
    uint32_t under_way[MOST_UNDER_WAY], messages; /* to whom */
    bool token_under_way;
    uint32_t token_to;
    struct safra_token token;
    uint32_t waves; /* begun */
    uint32_t seed;
};

static uint32_t draw(struct world *w, uint32_t below)
{
    w->seed = w->seed * 1664525 + 1013904223;
    return (w->seed >> 8) % below;
}

static void begin(struct world *w, uint32_t seed)
{
    *w = (struct world){.seed = seed};
    w->count = 1 + draw(w, MOST);
    for (uint32_t i = 0; i < w->count; i++)
        safra_begin(&w->process[i], i, w->count);
}

static bool all_rest(const struct world *w)
{
    for (uint32_t i = 0; i < w->count; i++)
        if (!w->rests[i])
            return false;
    return w->messages == 0;
}

static void send(struct world *w, uint32_t from)
{
    if (w->messages == MOST_UNDER_WAY)
        return;
    safra_sent(&w->process[from]);
    w->under_way[w->messages++] = draw(w, w->count);
}

/* The message may be one that ends no wait. */
static void receive(struct world *w)
{
    if (!w->messages)
        return;
    uint32_t which = draw(w, w->messages), to = w->under_way[which];
    w->under_way[which] = w->under_way[--w->messages];
    safra_received(&w->process[to]);
    if (draw(w, 2))
        w->rests[to] = false;
}

static void pass(struct world *w, uint32_t from)
{
    w->token = safra_pass(&w->process[from]);
    w->token_under_way = true;
    w->token_to = (from + 1) % w->count;
    w->waves += from == 0;
}

static void take_token(struct world *w)
{
    if (!w->token_under_way)
        return;
    w->token_under_way = false;
    safra_take(&w->process[w->token_to], w->token);
}

/* True: process 0 says that all is at rest. */
static bool handle_token(struct world *w, uint32_t who)
{
    if (!w->process[who].has_token || !w->rests[who])
        return false;
    if (who == 0 && safra_judge(&w->process[0]))
        return true;
    pass(w, who);
    return false;
}

/* One random step. `calm`: of 100 steps, about how many make a process rest. */
static bool step(struct world *w, uint32_t calm)
{
    uint32_t who = draw(w, w->count);
    if (draw(w, 100) < calm)
        w->rests[who] = true;
    if (!w->rests[who] && draw(w, 3) == 0)
        send(w, who);
    if (draw(w, 3) == 0)
        receive(w);
    if (draw(w, 2) == 0)
        take_token(w);
    return handle_token(w, who);
}

static void never_wrong_and_not_late(void **state)
{
    (void)state;
    for (uint32_t seed = 1; seed <= 20000; seed++) {
        struct world w;
        begin(&w, seed);
        uint32_t calm = 1 + draw(&w, 60);
        uint32_t rest_since = 0;
        bool rested = false;
        for (uint32_t steps = 0;; steps++) {
            bool found = step(&w, calm);
            if (found) {
                assert_true(all_rest(&w)); /* never wrong */
                break;
            }
            if (!rested && all_rest(&w))
                rested = true, rest_since = w.waves;
            assert_true(!rested || w.waves <= rest_since + 3); /* two waves behind the one under way */
            calm += steps > 2000;                              /* every program comes to rest */
        }
    }
}

/* A message that no process has received yet is seen, though all processes are at rest. */
static void sees_messages_under_way(void **state)
{
    (void)state;
    struct world w = {.count = 2, .rests = {true, true}};
    safra_begin(&w.process[0], 0, 2);
    safra_begin(&w.process[1], 1, 2);
    safra_sent(&w.process[1]);
    for (int wave = 0; wave < 10; wave++) {
        assert_false(handle_token(&w, 0));
        take_token(&w);
        assert_false(handle_token(&w, 1));
        take_token(&w);
    }
    safra_received(&w.process[0]);
    assert_false(handle_token(&w, 0));
    take_token(&w);
    assert_false(handle_token(&w, 1));
    take_token(&w);
    assert_true(handle_token(&w, 0));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(never_wrong_and_not_late),
        cmocka_unit_test(sees_messages_under_way),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
