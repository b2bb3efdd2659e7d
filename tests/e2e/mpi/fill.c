/* fill.c - all nodes write more into a file of /cfs than there is room for, in the I/O mode that the argument says. */
#include <nx.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>

static char bytes[40000];

int main(int argc, char **argv)
{
    int fd = gopen("/cfs/fill", O_RDWR | O_CREAT, argc > 1 ? atoi(argv[1]) : M_UNIX, 0666);
    for (int i = 0; i < 4; i++)
        cwrite(fd, bytes, sizeof bytes);
    gsync();
    printf("node %ld has written all\n", mynode());
    return 0;
}
