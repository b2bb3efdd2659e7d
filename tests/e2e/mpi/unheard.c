/* unheard.c - the only node sends long messages to all others: nobody takes them, and they keep no memory. */
#include <nx.h>
#include <stdio.h>
#include <sys/resource.h>

enum { LENGTH = 1 << 20, MESSAGES = 200 };
static char bytes[LENGTH];

static long most_kilobytes(void)
{
    struct rusage used;
    getrusage(RUSAGE_SELF, &used);
    return used.ru_maxrss;
}

int main(void)
{
    long before = most_kilobytes();
    for (int i = 0; i < MESSAGES; i++)
        csend(1, bytes, LENGTH, -1, mypid());
    printf("%s\n",
           most_kilobytes() - before < MESSAGES * (LENGTH / 1024) / 2 ? "nothing kept" : "messages kept");
    return 0;
}
