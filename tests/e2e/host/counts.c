/* counts.c - node: says how often it has been asked, and adds 100 if there is a message of type 3. */
#include "cube.h"

static long count;

int main(void)
{
    for (;;) {
        long one, said[2];
        crecv(1, &one, sizeof one);
        count += one;
        said[0] = mynode(), said[1] = count + 100 * iprobe(3);
        csend(2, said, sizeof said, myhost(), 0);
    }
}
