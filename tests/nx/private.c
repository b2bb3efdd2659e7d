/* Every node has globals, random numbers, strtok and errno of its own; output comes in the order of virtual
 * time.
 * run: -m delta -n 4
 */
#include <errno.h>
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int counter = 5;
static char words[] = "one two three four five";

int main(void)
{
    char *word = strtok(words, " ");
    long i, me = mynode();
    int first;
    srand(1);
    first = rand();
    srand((unsigned)me + 1);
    errno = (int)me + 1;
    for (i = 0; i < me; i++) {
        gsync();
        word = strtok(NULL, " ");
        counter++;
    }
    for (; i < 4; i++)
        gsync();
    if (errno != me + 1)
        printf("node %ld: errno is %d\n", me, errno);
    if (me == 0 && rand() != first)
        printf("rand is shared\n");
    for (i = 0; i < 4; i++) {
        if (i == 3 - me)
            printf("node %ld: counter %d, word %s\n", me, counter, word);
        gsync();
    }
    return 0;
}
