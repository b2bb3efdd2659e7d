/* Compiled for longs of 32 bits, as the i860 had them, a program and all that it calls agree on it:
 * constants, messages, the C library, NX's arrays of longs, and numbers of more than 32 bits.
 *
 * simulator only: --long32 is the node compiler's
 * compile: --long32
 * run: -n 1
 * run: -n 8
 * run: -m delta -n 3
 * run: -m delta -n 33
 */
#include <fcntl.h>
#include <inttypes.h>
#include <limits.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <time.h>
#include <estat.h>
#include <nx.h>

struct particle { /* of 12 bytes, as a Fortran program would send it */
    long id;
    int kind;
    long next;
};

static void print(const char *what, int good)
{
    if (mynode() == 0 || !good)
        printf("%s: %s\n", what, good ? "yes" : "NO");
}

static unsigned long hash(const char *s)
{
    unsigned long h = 5381;
    while (*s)
        h = h * 33 + (unsigned char)*s++;
    return h;
}

static void language(void)
{
    size_t size = sizeof(long);
    long one = 1, most = LONG_MAX;
    print("long, constants and pointed-to longs have 4 bytes",
          size == 4 && sizeof 1L == 4 && sizeof(struct particle) == 12 && sizeof(u_long) == 4);
    print("the most is 2^31 - 1, and unsigned longs wrap", most == 2147483647 && ULONG_MAX + one == 0);
    print("a hash as the i860 computed it",
          hash("the quick brown fox jumps over the lazy dog") == 0x77fb60fe);
    print("long long, size_t, pointers and large constants keep 8",
          sizeof(long long) == 8 && sizeof(size_t) == 8 && sizeof(ptrdiff_t) == 8 && sizeof 5000000000 == 8);
    print("1L << 31 is negative", (one << 31) < 0 && INT64_C(1) << 40 == 1099511627776);
}

static void library(void)
{
    char text[200];
    long a, b, t;
    unsigned long u;
    double d;
    long long wide;
    int count;
    sprintf(text, "%ld %5lu|%-8lx|%ld%% %s %lld %zu %.2lf %*ld %" PRId64, -7L, ULONG_MAX, 0xabcUL, 5L, "%ld",
            1LL << 40, sizeof a, 0.5, 4, 3L, (int64_t)-5000000000);
    print("printf", strcmp(text, "-7 4294967295|abc     |5% %ld 1099511627776 4 0.50    3 -5000000000") == 0);
    count = sscanf("12 0xff 2.5 1099511627776 a]l 77", "%ld%li%lf %lld %*[]%la] %lu", &a, &b, &d, &wide, &u);
    print("scanf", count == 5 && a == 12 && b == 255 && d == 2.5 && wide == 1LL << 40 && u == 77);
    print("strtol, atol, labs", strtol("-123", NULL, 10) == -123 && atol("45") == 45 && labs(-6L) == 6);
    time(&t);
    print("time", t >= 725846400 && t < 725846400 + 100);
}

static void messages(void)
{
    long me = mynode(), nodes = numnodes(), info[8], guard = 99, i, id, sum[2] = {me, 1}, work[2];
    long *lens = malloc(nodes * sizeof *lens), *all = malloc(nodes * sizeof *all);
    struct particle p = {me, 2, me + 1};
    crecvx(-1, &p, 0, me, 0, (csend(3, &p, 0, me, 0), info));
    print("info of a message", info[0] == 3 && info[1] == 0 && info[2] == me && info[3] == 0 && guard == 99);
    id = irecvx(4, &p, sizeof p, -1, -1, msginfo);
    csend(4, &p, sizeof p, (me + 1) % nodes, 0);
    msgwait(id);
    print("a struct as long as there", msginfo[1] == 12 && infocount() == 12 &&
                                           p.id == (me + nodes - 1) % nodes && p.next == p.id + 1 &&
                                           p.kind == 2);
    gisum(sum, 2, work);
    print("gisum", sum[0] == nodes * (nodes - 1) / 2 && sum[1] == nodes);
    for (i = 0; i < nodes; i++)
        lens[i] = sizeof(long);
    gcolx(&me, lens, all);
    for (i = 0; i < nodes && all[i] == i; i++)
        ;
    print("gcolx", i == nodes);
    gcol(&me, sizeof me, all, nodes * sizeof *all, &sum[0]);
    print("gcol", sum[0] == 4 * nodes && all[nodes - 1] == nodes - 1);
    gsendx(5, &me, sizeof me, all, nodes);
    for (i = 0; i < nodes; i++)
        crecv(5, &sum[1], sizeof sum[1]);
    print("gsendx and csendrecv", infocount() == 4 && csendrecv(6, &me, 4, me, 0, 6, &sum[1], 4) == 4);
    free(lens), free(all);
}

static void machine(void)
{
    long shape[3] = {0, 0, 77};
    esize_t size[2] = {{0, 0}, {5, 6}};
    mypart(&shape[0], &shape[1]);
    print("mypart", shape[0] * shape[1] == numnodes() && shape[2] == 77);
    hwclock(size);
    print("hwclock", size[0].shigh == 0 && size[0].slow != 0 && size[1].slow == 5);
    size[0].slow = -1, size[0].shigh = 1;
    size[0] = eadd(size[0], size[1]);
    print("eadd", size[0].slow == 4 && size[0].shigh == 8 && sizeof size[0] == 8);
}

static volatile double x = 1;

static void handler(long type, long count, long node, long pid)
{
    x = 0;
    (void)type, (void)count, (void)node, (void)pid;
}

/* The count of units, with which polls compare, has more bits than a long: this takes more than 2^31
 * thousandths of a clock. */
static void computing(void)
{
    double since = dclock();
    for (int i = 0; i < 1000000; i++)
        x = x * 1.0000001;
    print("computing takes its time", dclock() - since > 0.1 && dclock() - since < 10);
    hrecv(7, &since, 4, handler);
    csend(7, &since, 4, mynode(), 0);
    x = 1;
    for (int i = 0; i < 1000000 && x != 0; i++)
        x = x * 1.0000001;
    print("a handler interrupts it", x == 0);
}

static void file(void)
{
    esize_t place = {1, 0};
    struct estat st;
    int fd = gopen("/cfs/long32", O_RDWR | O_CREAT, M_UNIX, 0644);
    if (mynode() == 0)
        cwrite(fd, "abcdefgh", 8);
    gsync();
    place = eseek(fd, place, SIZE_END);
    festat(fd, &st);
    print("eseek, festat", place.slow == 9 && place.shigh == 0 && st.st_size.slow == 8 &&
                               st.st_size.shigh == 0 && st.st_blksize == 4096);
}

int main(void)
{
    language();
    library();
    messages();
    machine();
    computing();
    file();
    return 0;
}
