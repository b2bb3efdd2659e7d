/* csend never waits for the receiver to post: both partners send first, at any length, and then receive.
 * run: -m ipsc860 -n 2
 * run: -m delta -n 2
 */
#include <nx.h>
#include <stdio.h>

static char out[300000], in[300000];

int main(void)
{
    static const long sizes[] = {0, 1, 100, 101, 5000, 300000};
    long other = 1 - mynode();
    int i;
    for (i = 0; i < 6; i++) {
        out[0] = (char)(10 * i + mynode());
        csend(i, out, sizes[i], other, 0);
    }
    for (i = 5; i >= 0; i--) {
        crecv(i, in, sizeof in);
        if (infocount() != sizes[i] || (sizes[i] && in[0] != 10 * i + other))
            printf("node %ld: message %d is wrong\n", mynode(), i);
    }
    gsync();
    if (mynode() == 0)
        printf("exchanged\n");
    return 0;
}
