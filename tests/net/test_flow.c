/* The first of each sender's messages, however they come and go, as a plain list has it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "net/flow.h"
#include "net/proto_parts.h"

enum { MOST = 400, SENDERS = 40 };

static const struct trip *plain_first(struct trip *const there[], int count, uint32_t source)
{
    const struct trip *first = NULL;
    for (int i = 0; i < count; i++)
        if (there[i]->source == source && (!first || there[i]->order < first->order))
            first = there[i];
    return first;
}

static void the_first_of_each_sender_is_known(void **state)
{
    struct trip *all = calloc(MOST, sizeof *all), *there[MOST];
    struct flows *f = flows_new();
    int count = 0, made = 0;
    (void)state;
    srand(1);
    for (int step = 0; step < 20000; step++) {
        if (count < MOST && made - step / 60 < MOST && rand() % 2) {
            struct trip *t = &all[0];
            while (t->m) /* in use */
                t++;
            *t = (struct trip){
                .m = (void *)1, .source = (uint32_t)(rand() % SENDERS) * 977, .order = (uint64_t)made++};
            if (rand() % 10 == 0)
                t->order += (uint64_t)(rand() % 50); /* some are made before others and sent behind them */
            for (int i = 0; i < count; i++)
                if (there[i]->source == t->source && there[i]->order == t->order)
                    t->order = (uint64_t)made++ + 100000;
            there[count++] = t;
            flows_add(f, t);
        } else if (count) {
            int i = rand() % count;
            if (rand() % 3) /* mostly the first of a sender */
                for (int k = 0; k < count; k++)
                    i = there[k]->source == there[i]->source && there[k]->order < there[i]->order ? k : i;
            flows_remove(f, there[i]);
            there[i]->m = NULL;
            there[i] = there[--count];
        }
        uint32_t source = (uint32_t)(rand() % SENDERS) * 977;
        assert_ptr_equal(flows_first(f, source), plain_first(there, count, source));
    }
    flows_free(f);
    free(all);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_first_of_each_sender_is_known)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
