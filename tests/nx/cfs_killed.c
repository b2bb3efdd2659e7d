/* A node that ends, or is killed, in the middle of reads and writes: what the I/O nodes have got is written,
 * the rest is not, and nobody else is hurt.
 * run: -m ipsc860 -n 3
 * run: -m delta -n 3
 */
#include <fcntl.h>
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int main(void)
{
    char *buf = malloc(2000000);
    int fd = gopen("/cfs/killed", O_RDWR | O_CREAT | O_TRUNC, M_UNIX, 0666);
    memset(buf, 'a' + (int)mynode(), 2000000);
    gsync();
    if (mynode() == 1) {
        iwrite(fd, buf, 8000); /* all bytes are sent at once */
        return 0;
    }
    if (mynode() == 2) {
        lseek(fd, 8000, SEEK_SET);
        cwrite(fd, buf, 2000000);
        printf("not reached\n");
    }
    usleep(20000);
    killproc(2, 0);
    usleep(2000000);
    printf("%ld read, ", cread(fd, buf, 8000));
    printf("%c to %c, then %s\n", buf[0], buf[7999], lsize(fd, 0, SIZE_END) < 2008000 ? "not all" : "all");
    return 0;
}
