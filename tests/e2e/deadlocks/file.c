/* file.c - in I/O mode 2 node 1 writes after node 0, which does not write. */
#include <fcntl.h>
#include "nx.h"

int main(void)
{
    char buf[8] = "";
    int fd = gopen("/cfs/shared", O_CREAT | O_RDWR, 2, 0666);

    if (mynode() == 1)
        cwrite(fd, buf, sizeof buf);
    gsync();
    return 0;
}
