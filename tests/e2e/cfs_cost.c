/* Writes 4096 bytes into a file of /cfs, and reads them: microseconds of each of the two calls. */
#include <fcntl.h>
#include <nx.h>
#include <stdio.h>
#include <unistd.h>

int main(void)
{
    static char block[4096];
    double begin, written, moved, read_back;
    int fd = open("/cfs/block", O_RDWR | O_CREAT, 0644);
    begin = dclock();
    write(fd, block, sizeof block);
    written = dclock();
    lseek(fd, 0, SEEK_SET);
    moved = dclock();
    read(fd, block, sizeof block);
    read_back = dclock();
    printf("%.1f %.1f\n", (written - begin) * 1e6, (read_back - moved) * 1e6);
    return 0;
}
