/* scope.c - arrays of scopes that follow each other, and of calls within calls.
 * report: stack-buffer-overflow: write of 1 byte, just behind small (10 bytes, */
#include <stdio.h>
#include "nx.h"

static void set(char *all, int n)
{
    int i;
    for (i = 0; i < n; i++)
        all[i] = (char)i; /* FAULT */
}

static int deep(int levels)
{
    char own[33];
    set(own, 33);
    return levels ? deep(levels - 1) + own[levels] : 0;
}

int main(void)
{
    int s = 0, i;
    for (i = 0; i < 3; i++) {
        if (i != 1) {
            char large[1000];
            set(large, 1000);
            s += large[i];
        } else {
            char small[10];
#ifdef CORRECT
            set(small, 10);
#else
            set(small, 11);
#endif
            s += small[i];
        }
    }
    printf("%d\n", s + deep(20));
    return 0;
}
