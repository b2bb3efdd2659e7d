/* The first of each queue, and those behind it, however they come and go, as a plain list has them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <malloc.h>
#include "kernel/queues.h"

enum { MOST = 400, NUMBERS = 40 };

struct thing {
    uint32_t number;
    int64_t order;
    int in_use;
};

/* The thing of a number that so many are before. */
static const struct thing *plain_at(struct thing *const there[], int count, uint32_t number, uint32_t at)
{
    for (int i = 0; i < count; i++) {
        uint32_t before = 0;
        for (int k = 0; k < count; k++)
            before += there[k]->number == number && there[k]->order < there[i]->order;
        if (there[i]->number == number && before == at)
            return there[i];
    }
    return NULL;
}

static struct thing *unused(struct thing all[])
{
    while (all->in_use)
        all++;
    return all;
}

/* Mostly behind all, sometimes before all, sometimes between. */
static int64_t some_order(int64_t step)
{
    int how = rand() % 10;
    return how == 0 ? -step : how == 1 ? step - rand() % 1000 * 2 - 1 : 2 * step;
}

static bool is_taken(struct thing *const there[], int count, int64_t order)
{
    for (int i = 0; i < count; i++)
        if (there[i]->order == order)
            return true;
    return false;
}

static void they_are_as_in_a_plain_list(void **state)
{
    struct thing *all = calloc(MOST, sizeof *all), *there[MOST];
    struct queues *q = queues_new();
    int count = 0;
    (void)state;
    srand(1);
    for (int64_t step = 1; step < 20000; step++) {
        int64_t order = some_order(step);
        if (count < MOST && (rand() % 2 || count < step / 60) && !is_taken(there, count, order)) {
            struct thing *t = unused(all);
            *t = (struct thing){(uint32_t)(rand() % NUMBERS) * 977, order, 1};
            there[count++] = t;
            queues_add(q, t->number, t->order, t);
        } else if (count) {
            int i = rand() % count;
            const struct thing *first = plain_at(there, count, there[i]->number, 0);
            for (int k = 0; k < count && rand() % 3; k++) /* mostly the first of its queue */
                i = there[k] == first ? k : i;
            queues_remove(q, there[i]->number, there[i]);
            there[i]->in_use = 0;
            there[i] = there[--count];
        }
        uint32_t number = (uint32_t)(rand() % NUMBERS) * 977, at = (uint32_t)(rand() % 3);
        assert_ptr_equal(queues_at(q, number, at), plain_at(there, count, number, at));
    }
    queues_free(q);
    free(all);
}

/* One number stays; a million come and go. */
static void numbers_that_are_gone_take_no_memory(void **state)
{
    struct queues *q = queues_new();
    int item, staying;
    (void)state;
    queues_add(q, 7, 0, &staying);
    size_t before = mallinfo2().uordblks;
    for (uint32_t number = 8; number < 1000000; number++) {
        queues_add(q, number, number, &item);
        assert_ptr_equal(queues_at(q, number, 0), &item);
        queues_remove(q, number, &item);
    }
    assert_in_range(mallinfo2().uordblks, 0, before + 4096);
    assert_ptr_equal(queues_at(q, 7, 0), &staying);
    queues_free(q);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(they_are_as_in_a_plain_list),
                                       cmocka_unit_test(numbers_that_are_gone_take_no_memory)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
