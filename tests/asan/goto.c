/* goto.c - a goto out of a nested function leaves functions that have arrays, and arguments of others use
 * their place in the stack.
 * report: stack-buffer-overflow: write of 1 byte, just behind line (80 bytes, */
#include <stdio.h>
#include <string.h>
#include "nx.h"

struct large {
    char bytes[1500];
};

#ifdef CORRECT
enum { WIDTH = 80 };
#else
enum { WIDTH = 100 };
#endif

static struct large all;

static void parse(int depth, void (*give_up)(void))
{
    char word[24];
    memset(word, depth, sizeof word);
    if (depth == 0)
        give_up();
    parse(depth - 1, give_up);
    printf("%d\n", word[0]);
}

static int parses(void)
{
    __label__ failed;
    void give_up(void)
    {
        goto failed;
    }
    parse(9, give_up);
    return 1;
failed:
    return 0;
}

static __attribute__((noinline)) int sum(struct large l, int n)
{
    char line[80];
    int i, s = 0;
    for (i = 0; i < n; i++) {
        s += l.bytes[i];
        line[i % WIDTH] = 'a'; /* FAULT */
    }
    return s + line[n % 80];
}

int main(int argc, char **argv)
{
    int parsed = parses();
    printf("%d %d\n", parsed, sum(all, argc + 1400));
    return 0;
}
