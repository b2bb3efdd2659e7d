/* jump.c - longjmp leaves functions that have arrays, and others use their place in the stack.
 * report: stack-buffer-overflow: write of ... just behind line (80 bytes, */
#include <setjmp.h>
#include <stdio.h>
#include <string.h>
#include "nx.h"

static jmp_buf out;

static void parse(int depth)
{
    char word[24];
    memset(word, depth, sizeof word);
    if (depth == 0)
        longjmp(out, 1);
    parse(depth - 1);
    printf("%d\n", word[0]);
}

static void copy(int n)
{
    char line[80], large[500];
    int i;
    memset(large, 'a', sizeof large);
    for (i = 0; i < n; i++)
        line[i] = large[i]; /* FAULT */
    printf("%.3s\n", line);
}

int main(int argc, char **argv)
{
    if (setjmp(out) == 0)
        parse(9);
#ifdef CORRECT
    copy(argc + 79);
#else
    copy(argc + 80);
#endif
    return 0;
}
