/* One node writes into a file of the parallel file system: alone, and what 64 nodes send it, by pieces. */
#include <fcntl.h>
#include <unistd.h>
#include "bench.h"

enum { TYPE = 9, LONG = 131072 };
static char piece[LONG];

/* Milliseconds a piece; senders: node 0 gets all but its own first. */
static double piece_ms(const char *path, long bytes, int senders)
{
    double begin = 0;
    gsync();
    if (mynode() > 0) {
        if (senders)
            csend(TYPE, piece, bytes, 0, 0);
        return 0;
    }
    int fd = open(path, O_CREAT | O_WRONLY | O_TRUNC, 0644);
    begin = now_us();
    for (int i = 0; i < numnodes(); i++) {
        if (senders && i > 0)
            crecv(TYPE, piece, bytes);
        cwrite(fd, piece, bytes);
    }
    close(fd);
    return (now_us() - begin) / 1000 / (double)numnodes();
}

int main(void)
{
    double ms[] = {piece_ms("/pfs/a", LONG / 4, 0), piece_ms("/pfs/b", LONG, 0),
                   piece_ms("/pfs/c", LONG / 4, 1), piece_ms("/pfs/d", LONG, 1)};
    if (mynode() == 0) {
        figure("write_32_ms", ms[0]);
        figure("write_128_ms", ms[1]);
        figure("piece_32_ms", ms[2]);
        figure("piece_128_ms", ms[3]);
    }
    return 0;
}
