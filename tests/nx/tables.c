/* Tables and trees of the program's, and orders by its functions, as System V and GNU have them.
 * compile: -D_GNU_SOURCE
 * again: --long32
 * run: all
 */
#include <errno.h>
#include <search.h>
#include <stdlib.h>
#include <string.h>
#include "rule.h"

enum { MANY = 500 };

static char keys[MANY][8];
static int numbers[MANY];

/* Chooses numbers that are the same in any run, and others on each node. */
static void fill(void)
{
    for (int i = 0; i < MANY; i++) {
        numbers[i] = (int)((i * 197 + mynode() * 31) % MANY);
        snprintf(keys[i], sizeof keys[i], "k%d", numbers[i]);
    }
}

static int a_table(void)
{
    ENTRY *e, absent = {"absent", NULL};
    int good = hcreate(MANY) != 0 && hcreate(MANY) == 0;
    for (int i = 0; good && i < MANY; i++)
        good = hsearch((ENTRY){keys[i], &numbers[i]}, ENTER) != NULL;
    gsync();
    for (int i = 0; good && i < MANY; i++)
        good = (e = hsearch((ENTRY){keys[i], NULL}, FIND)) && e->key == keys[i] && e->data == &numbers[i];
    e = hsearch((ENTRY){"k0", &absent}, ENTER);
    good = good && e && *(int *)e->data == 0 && !hsearch(absent, FIND) && errno == ESRCH;
    hdestroy();
    return good && hcreate(1) && !hsearch((ENTRY){"k0", NULL}, FIND) && (hdestroy(), 1);
}

static int of_its_own(void)
{
    struct hsearch_data a = {0}, b = {0};
    ENTRY *e;
    int good = hcreate_r(3, &a) && hcreate_r(3, &b) && hsearch_r((ENTRY){"x", keys}, ENTER, &e, &a);
    good = good && !hsearch_r((ENTRY){"x", NULL}, FIND, &e, &b) && !e;
    return good && hsearch_r((ENTRY){"x", NULL}, FIND, &e, &a) && e->data == keys &&
           (hdestroy_r(&a), hdestroy_r(&b), 1);
}

static int by_number(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

static int last, in_order, deepest;

static void visit(const void *node, VISIT when, int level)
{
    int x = **(int *const *)node;
    if (level > deepest)
        deepest = level;
    if (when == postorder || when == leaf) {
        in_order += x > last;
        last = x;
    }
}

static int released;

static void release(void *key)
{
    released += key != NULL;
}

static int a_tree(void)
{
    void *root = NULL, *at;
    int good = 1, absent = -5;
    for (int i = 0; i < MANY; i++)
        good = good && (at = tsearch(&numbers[i], &root, by_number)) && *(int **)at == &numbers[i];
    last = -1, in_order = deepest = 0;
    twalk(root, visit);
    good = good && in_order == MANY && deepest < 13;
    for (int i = 0; i < MANY; i += 2)
        good = good && tdelete(&numbers[i], &root, by_number) != NULL;
    good = good && !tdelete(&numbers[0], &root, by_number) && !tfind(&absent, &root, by_number);
    for (int i = 0; i < MANY; i++)
        good = good && !tfind(&numbers[i], &root, by_number) == !(i % 2);
    last = -1, in_order = deepest = 0;
    twalk(root, visit);
    tdestroy(root, release);
    return good && in_order == MANY / 2 && deepest < 12 && released == MANY / 2;
}

static int by_way(const void *a, const void *b, void *way)
{
    return *(int *)way * by_number(a, b);
}

static int in_either_order(void)
{
    int up = 1, down = -1, list[MANY], good = 1;
    memcpy(list, numbers, sizeof list);
    qsort_r(list, MANY, sizeof *list, by_way, &down);
    for (int i = 0; i < MANY; i++)
        good = good && list[i] == MANY - 1 - i;
    qsort_r(list, MANY, sizeof *list, by_way, &up);
    return good && list[0] == 0 && list[MANY - 1] == MANY - 1;
}

static int in_a_list(void)
{
    size_t count = 3;
    int list[4] = {5, 6, 7}, six = 6, nine = 9;
    int *found = lfind(&six, list, &count, sizeof *list, by_number);
    int good = found == list + 1 && !lfind(&nine, list, &count, sizeof *list, by_number);
    return good && lsearch(&nine, list, &count, sizeof *list, by_number) == list + 3 && count == 4;
}

int main(void)
{
    fill();
    rule("hsearch", a_table());
    rule("hsearch_r", of_its_own());
    rule("tsearch, tfind, tdelete, twalk", a_tree());
    rule("qsort_r", in_either_order());
    rule("lsearch", in_a_list());
    return 0;
}
