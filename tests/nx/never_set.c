/* never_set.c - a local variable that the program has never set reads as 0, wherever it lies; one that has
 * been set keeps its value for as long as its scope lasts, round loops, too. All nodes try, node 0 prints.
 * simulator only: on MPI a local variable holds what lay there
 * run: all
 * compile: -w -fno-strict-aliasing
 * again: -O0
 * again: -O1 --asan
 */
#include <alloca.h>
#include <setjmp.h>
#include <stdio.h>
#include <string.h>
#include "nx.h"

static volatile int three = 3, zero = 0;

/* Leaves something on the stack below its caller. */
__attribute__((noinline)) static int litter(int depth)
{
    volatile char bytes[3000];
    memset((void *)bytes, 0x5a, sizeof bytes);
    return depth > 0 ? litter(depth - 1) + bytes[depth] : bytes[0];
}

/* The sum of bytes that the compiler cannot know. */
__attribute__((noinline)) static unsigned sum(const void *at, int bytes)
{
    const unsigned char *p = at;
    unsigned s = 0;
    for (int i = 0; i < bytes; i++)
        s = s * 31 + p[i];
    return s;
}

static unsigned array(void)
{
    char never[2000];
    return sum(never, sizeof never);
}

static unsigned structure(void)
{
    struct {
        int a, b;
        double c[20];
    } s;
    s.b = zero;
    return sum(&s, sizeof s);
}

static unsigned assembler_says_so(void)
{
    char never[500];
    __asm__ volatile("" : "=m"(never));
    return sum(never, sizeof never);
}

static unsigned variable_length(void)
{
    char never[three * 100];
    return sum(never, three * 100) + sum(alloca(three * 50), three * 50);
}

__attribute__((noipa)) static long number(int set)
{
    long n;
    double x;
    if (set)
        n = three, x = three;
    return n + (long)x;
}

__attribute__((noipa)) static int no_value(int give)
{
    if (give)
        return three;
}

/* Set in the first round, used in the others. */
static int carried(void)
{
    int kept[50], total = 0;
    for (int round = 0; round < three; round++) {
        if (round == 0)
            for (int i = 0; i < 50; i++)
                kept[i] = i;
        litter(1);
        total += kept[round * 10 + 1] + (int)(sum(kept, sizeof kept) & 1);
    }
    return total;
}

/* A loop within the scope of a variable of the outer loop's body. */
static int carried_within(void)
{
    int total = 0, turns = 0;
    while (turns < 6) {
        int count[40];
        if (turns % 3 == 0)
            memset(count, 0, sizeof count);
    again:
        count[turns]++;
        turns++;
        litter(0);
        if (turns % 3)
            goto again;
        total = total * 10 + (int)(sum(count, sizeof count) != 0) + count[turns - 1] + count[turns - 3];
    }
    return total;
}

/* Each round begins anew. */
static unsigned fresh_in_each_round(void)
{
    unsigned total = 0;
    for (int round = 0; round < three; round++) {
        char never[100];
        total += sum(never, sizeof never);
        memset(never, 1, sizeof never);
        total += sum(never, sizeof never) == 0;
    }
    return total;
}

static int round_a_jump(void)
{
    static jmp_buf back;
    volatile int rounds[30];
    rounds[0] = 10;
    int turn = setjmp(back);
    rounds[0]++;
    if (turn < 3)
        longjmp(back, turn + 1);
    return rounds[0];
}

__attribute__((noinline)) static void put_seven(int *at)
{
    at[0] = 7;
}

/* What was set by the one name is there under the other: the address of a local variable, or another's. */
__attribute__((noinline)) static int by_another_name(int *given)
{
    int own[3];
    int *at = given ? given : own;
    put_seven(at);
    return at[0] + at[2];
}

int main(void)
{
    FILE *out = mynode() == 0 ? stdout : fopen("/dev/null", "w");
    litter(3);
    fprintf(out, "array %u structure %u", array(), structure());
    litter(3);
    fprintf(out, " assembler %u variable %u", assembler_says_so(), variable_length());
    litter(3);
    fprintf(out, " number %ld %ld value %d %d\n", number(zero), number(1), no_value(zero), no_value(1));
    gsync();
    fprintf(out, "carried %d %d fresh %u jump %d\n", carried(), carried_within(), fresh_in_each_round(),
            round_a_jump());
    litter(3);
    int others[3] = {0, 0, three};
    fprintf(out, "another name %d %d\n", by_another_name(NULL), by_another_name(others));
    return 0;
}
