/* rates.c - the rates that the Concurrent File System sustains, of all n nodes together.
 *
 *   rates PATTERN MB RECORD_KB     PATTERN: records       one file, node i has every n-th record (I/O mode 3)
 *                                           partitions    one file, node i has its own n-th part (mode 0)
 *
 * Writes a file of MB megabytes (10^6 bytes, rounded to whole rounds of records), then reads the file, and
 * prints both rates. A rate is taken over the second half of the file, when caches are full and for each byte
 * accepted one byte goes to disk.
 */
#include <fcntl.h>
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct run {
    int fd;
    char *buf;
    long record, rounds;
};

/* Writes or reads all rounds of records. Answers the seconds from the middle to the end, of the slowest
 * node. */
static double all_rounds(const struct run *r, int write)
{
    double begin = 0, took, work;
    long i;
    for (i = 0; i < r->rounds; i++) {
        if (i == r->rounds / 2) {
            gsync();
            begin = dclock();
        }
        if ((write ? cwrite(r->fd, r->buf, r->record) : cread(r->fd, r->buf, r->record)) != r->record)
            abort();
    }
    gsync();
    took = dclock() - begin;
    gdhigh(&took, 1, &work);
    return took;
}

int main(int argc, char **argv)
{
    struct run r;
    double megabytes, wrote, read;
    int records = argc == 4 && strcmp(argv[1], "records") == 0;
    if (argc != 4 || (!records && strcmp(argv[1], "partitions") != 0)) {
        if (mynode() == 0)
            fprintf(stderr, "usage: rates records|partitions MB RECORD_KB\n");
        return 64;
    }
    r.record = atol(argv[3]) * 1024;
    r.rounds = (long)(atof(argv[2]) * 1e6 / ((double)r.record * (double)numnodes()) + 0.5);
    r.rounds = r.rounds < 2 ? 2 : r.rounds + r.rounds % 2;
    r.buf = malloc((size_t)r.record);
    if (!r.buf)
        abort();
    memset(r.buf, (int)mynode(), (size_t)r.record);

    r.fd = gopen("/cfs/rates", O_RDWR | O_CREAT | O_TRUNC, records ? M_RECORD : M_UNIX, 0666);
    if (!records)
        lseek(r.fd, mynode() * r.rounds * r.record, SEEK_SET);
    wrote = all_rounds(&r, 1);
    lseek(r.fd, records ? 0 : mynode() * r.rounds * r.record, SEEK_SET);
    gsync();
    read = all_rounds(&r, 0);
    close(r.fd);
    megabytes = 1e-6 * (double)r.record * (double)(r.rounds / 2) * (double)numnodes();
    if (mynode() == 0)
        printf("%ld %.3f %.3f\n", numnodes(), megabytes / wrote, megabytes / read);
    return 0;
}
