/* Reads under way, messages and handlers at the same time: times do not depend on how computing is sliced.
 * run: -m ipsc860 -n 4
 * run: -m ipsc860 -n 4 --slice 0.000003
 * run: -m ipsc860 -n 4 --slice 0.0007
 */
#include <fcntl.h>
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

enum { BYTES = 150000 };
static long handled;
static volatile double sum;
static char note[8];

static void on_note(long type, long count, long node, long pid)
{
    (void)count, (void)pid;
    handled += node + type;
    hrecv(5, note, sizeof note, on_note);
}

static void compute(long n)
{
    long i;
    for (i = 0; i < n; i++)
        sum += (double)i;
}

int main(void)
{
    char *in = malloc(BYTES), small[8] = {0};
    int fd = gopen("/cfs/handlers", O_RDWR | O_CREAT | O_TRUNC, M_LOG, 0666), i;
    long id, other = (mynode() + 1) % numnodes();
    FILE *f;
    hrecv(5, note, sizeof note, on_note);
    gsync();
    lsize(fd, 4 * BYTES, SIZE_SET);
    for (i = 0; i < 4; i++) {
        id = i % 2 ? iwrite(fd, in, BYTES / 3) : iread(fd, in, BYTES);
        compute(20000);
        csend(5, small, 8, other, 0);
        compute(30000 * (1 + mynode()));
        if (i == 2)
            while (!iodone(id))
                compute(100);
        else
            iowait(id);
        csend(5, small, 4, other, 0);
    }
    f = fopen("/cfs/text", mynode() == 0 ? "w" : "a");
    for (i = 0; i < 3000; i++)
        fprintf(f, "%d ", i);
    csend(5, small, 8, other, 0);
    fclose(f);
    gsync();
    printf("%ld: %.9f %ld\n", mynode(), dclock(), handled);
    return 0;
}
