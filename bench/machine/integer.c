/* Integer code and procedure calls, as compiled: nanoseconds of each, in cache. */
#include "bench.h"

enum { TIMES = 1000, CELLS = 256, KEYS = 200 };

struct cell {
    struct cell *next;
    int key;
};

static struct cell cells[CELLS];
static int keys[KEYS], state;
static volatile int sink;

/* Not a leaf, so that it has a frame. */
__attribute__((noinline)) static int fibonacci(int n)
{
    return n < 2 ? n : fibonacci(n - 1) + fibonacci(n - 2);
}

static int walk(void)
{
    int sum = 0;
    for (const struct cell *c = cells; c; c = c->next)
        sum += c->key;
    return sum;
}

/* By insertion: comparisons, branches, moves. */
static int sort(void)
{
    int moves = 0;
    for (int i = 0; i < KEYS; i++)
        keys[i] = (i * 37) % KEYS;
    for (int i = 1; i < KEYS; i++) {
        int key = keys[i], k = i;
        for (; k > 0 && keys[k - 1] > key; k--, moves++)
            keys[k] = keys[k - 1];
        keys[k] = key;
    }
    return moves;
}

/* Static variables, read and written. */
__attribute__((noinline)) static int next_state(void)
{
    return state = (state << 3 ^ state >> 2 ^ 5) & 1023;
}

static int states(void)
{
    for (int i = 0; i < TIMES; i++)
        next_state();
    return state;
}

/* A figure: nanoseconds of each of `operations` operations since begin. */
static void measure(const char *name, double begin, double operations)
{
    figure(name, (now_us() - begin) * 1e3 / operations);
}

int main(void)
{
    for (int i = 0; i < CELLS; i++)
        cells[i] = (struct cell){i + 1 < CELLS ? &cells[i + 1] : NULL, i};
    double begin = now_us();
    sink = fibonacci(18);
    measure("call_ns", begin, 8361); /* calls in fibonacci(18) */
    begin = now_us();
    sink = walk();
    measure("list_ns", begin, CELLS);
    begin = now_us();
    int moves = sort();
    measure("sort_ns", begin, moves);
    begin = now_us();
    sink = states();
    measure("state_ns", begin, TIMES);
    return 0;
}
