/* Writes a line into a file of /cfs ("write"), or prints what it finds there ("read"); anything else is a
 * name to open. */
#include <fcntl.h>
#include <nx.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

int main(int argc, char **argv)
{
    char line[64] = {0};
    int fd;
    if (argc == 2 && strcmp(argv[1], "write") == 0) {
        fd = gopen("/cfs/kept/lines", O_RDWR | O_CREAT, M_RECORD, 0644);
        sprintf(line, "node %ld of %ld\n", mynode(), numnodes());
        cwrite(fd, line, 16);
    } else if (argc == 2 && strcmp(argv[1], "read") == 0) {
        fd = gopen("/cfs/kept/lines", O_RDONLY, M_SYNC, 0);
        write(1, line, cread(fd, line, 16));
    } else {
        gopen(argv[1], O_RDONLY, M_UNIX, 0);
    }
    return 0;
}
