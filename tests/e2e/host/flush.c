/* flush.c - host: throws away a message that has come. */
#include <stdio.h>
#include "cube.h"

int main(void)
{
    long one = 1, before;
    getcube("c", "1", "", 0);
    load("counts", -1, 0);
    csend(1, &one, sizeof one, 0, 0);
    cprobe(2);
    before = iprobe(2);
    flushmsg(-1, myhost(), mypid());
    printf("before %ld, after %ld\n", before, iprobe(2));
    killcube(-1, -1);
    return 0;
}
