/* Writes and reads a file in I/O mode M_GLOBAL; with an argument, each node gives another length. */
#include <fcntl.h>
#include <nx.h>
#include <unistd.h>

static char data[200000];

int main(int argc, char **argv)
{
    int fd = gopen("/pfs/global", O_RDWR | O_CREAT | O_TRUNC, M_GLOBAL, 0644);
    (void)argv;
    cwrite(fd, data, sizeof data);
    lseek(fd, 0, SEEK_SET);
    return cread(fd, data, sizeof data - (argc > 1 ? (unsigned long)mynode() : 0)) == sizeof data ? 0 : 3;
}
