/* A read or write begun with iread or iwrite continues while the program computes: both at a time take less
 * than one after the other. Written bytes are taken at once; read bytes are there after iowait or iodone.
 * run: -m ipsc860 -n 1
 * run: -m delta -n 1
 */
#include <fcntl.h>
#include <nx.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { BYTES = 200000 };
static char out[BYTES], in[BYTES];
static volatile double sum;

static double compute(void)
{
    double t = dclock();
    long i;
    for (i = 0; i < 400000; i++)
        sum += (double)i;
    return dclock() - t;
}

int main(void)
{
    static const int disk[] = {0};
    int fd = gopen("/cfs/overlap", O_RDWR | O_CREAT | O_TRUNC, M_UNIX, 0666), write;
    long id, polls, i;
    for (i = 0; i < BYTES; i++)
        out[i] = (char)(i % 251);
    restrictvol(fd, 1, disk); /* one I/O node is slower than the node itself */
    for (write = 1; write >= 0; write--) {
        double t, alone, computing, together;
        lseek(fd, 0, SEEK_SET);
        computing = compute();
        t = dclock();
        if (write)
            cwrite(fd, out, BYTES);
        else
            cread(fd, in, BYTES);
        alone = dclock() - t;
        lseek(fd, 0, SEEK_SET);
        t = dclock();
        id = write ? iwrite(fd, out, BYTES) : iread(fd, in, BYTES);
        if (write)
            memset(out, 0, 1000);
        compute();
        iowait(id);
        together = dclock() - t;
        printf("%s: overlap %s\n", write ? "write" : "read",
               together < 0.9 * (alone + computing) ? "pays" : "does not pay");
    }
    for (i = 0; i < 1000; i++)
        out[i] = (char)(i % 251);
    printf("bytes %s\n", memcmp(in, out, BYTES) ? "differ" : "are right");

    lseek(fd, 0, SEEK_SET);
    id = iread(fd, in, BYTES);
    for (polls = 0; !iodone(id); polls++)
        ;
    printf("polled %s\n", polls > 10 ? "a while" : "hardly");
    iowait(id); /* given back already: an error */
    return 0;
}
