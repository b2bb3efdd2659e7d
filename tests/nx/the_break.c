/* sbrk and brk: memory of the program's own beside malloc's, whose blocks raise the break, too.
 * simulator only: a cluster's own malloc does not move the break
 * compile: -w
 * again: --long32 --asan
 * run: all
 */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "rule.h"

char *sbrk();
static char *begin, *end;

static int without_gaps(void)
{
    begin = sbrk(0);
    int good = begin != (char *)-1 && sbrk(5000) == begin && sbrk(1) == begin + 5000;
    for (int i = 0; i < 5001; i++)
        good = good && begin[i] == 0;
    memset(begin, 7, 5001);
    end = sbrk(0);
    return good && end == begin + 5001 && sbrk(-5001) == end && sbrk(100) == begin && begin[0] == 0;
}

static int sets_the_end(void)
{
    int good = brk(begin + 300) == 0 && sbrk(0) == begin + 300 && brk(begin) == 0 && sbrk(0) == begin;
    errno = 0;
    return good && brk(begin - 1) == -1 && errno == ENOMEM && sbrk(-1) == (char *)-1 && sbrk(0) == begin;
}

/* Programs print this difference as what they have allocated. */
static int malloc_raises_it(void)
{
    char *block = malloc(20000);
    int good = sbrk(0) - begin >= 20000 && sbrk(10) > block;
    free(block);
    return good;
}

static int it_is_the_node_s_memory(void)
{
    long bytes = 0;
    while (sbrk(1 << 18) != (char *)-1)
        bytes += 1 << 18;
    int good = errno == ENOMEM && bytes > 8 << 20 && bytes < 16 << 20 && malloc(1 << 19) == NULL;
    return good && sbrk(-1 << 20) != (char *)-1 && malloc(1 << 19) != NULL;
}

static int messages_lie_there(void)
{
    long *out = (long *)sbrk(8000), *in = out + 500, good = 1;
    for (int i = 0; i < 500; i++)
        out[i] = mynode() + i;
    csend(5, out, 500 * sizeof(long), next_node(), 0);
    crecv(5, in, 500 * sizeof(long));
    for (int i = 0; i < 500; i++)
        good = good && in[i] == last_node() + i;
    return good;
}

/* This computer puts what it maps at 0x7e... or 0x7f..., where depends on the run. */
static int is_the_same_in_every_run(void)
{
    return (unsigned long long)sbrk(0) >> 40 < 0x7e;
}

int main(void)
{
    rule("without gaps, and zero", without_gaps());
    rule("the same in every run", is_the_same_in_every_run());
    rule("brk sets it", sets_the_end());
    rule("messages from there, and to there", messages_lie_there());
    rule("malloc raises it", malloc_raises_it());
    rule("up to the node's memory", it_is_the_node_s_memory());
    return 0;
}
