/* halves.c - for the test of studies: prints figures, writes a file, and fails when told to. */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

int main(int argc, char **argv)
{
    double work, share = argc > 1 ? atof(argv[1]) : 1;
    FILE *file = fopen("/cfs/left", "r");

    gdsum(&share, 1, &work);
    if (mynode() != 0)
        return 0;
    if (share == 12)
        exit(3); /* four nodes and a share of 3 */
    if (file)
        printf("left_by_another 1\n");
    fclose(fopen("/cfs/left", "w"));
    printf("sum %.2f\nwords for people 7\n", share);
    printf("total_s %.9f\n", dclock());
    return 0;
}
