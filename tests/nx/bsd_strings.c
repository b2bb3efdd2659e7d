/* BSD's calls on strings and bytes, declared as its programs did; and what GCC makes of strcpy and strlen.
 * compile: -D_GNU_SOURCE
 * run: all
 */
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <nx.h>

/* By their addresses, so that the functions themselves are there. */
static long by_address(void)
{
    void *(*volatile copy)(void *, const void *, size_t) = mempcpy;
    char *(*volatile find)(const char *, int) = index, *(*volatile find_last)(const char *, int) = rindex;
    void (*volatile move)(const void *, void *, size_t) = bcopy, (*volatile clear)(void *, size_t) = bzero;
    int (*volatile compare)(const void *, const void *, size_t) = bcmp, (*volatile first)(int) = ffs;
    static char a[16] = "abcabc", b[16] = "xxxxxxxxxxxxxxx";
    clear(b, sizeof b);
    move(a, b, sizeof b);
    return (compare(a, b, 16) == 0) + 10 * (find(b, 'b') == b + 1) + 100 * (find_last(b, 'b') == b + 4) +
           1000 * (first(8) == 4) + 10000 * (copy(b, "z", 2) == b + 2) + 100000 * (*b == 'z');
}

int main(int argc, char **argv)
{
    char name[200], *p = name;
    (void)argc;
    strcpy(p, argv[0] ? "part" : "");
    p += strlen(p);
    strcpy(p, ".info");
    strcat(name, ".1");
    if (mynode() == 0)
        printf("%d %s %ld\n", (int)strlen(name), name, by_address());
    return 0;
}
