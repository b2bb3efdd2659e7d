/* A poll loses nothing of what a program has in registers, however wide: sums in a loop that handlers
 * interrupt, which use the same registers, are those of a loop that none does.
 * run: -m delta -n 2
 * run: -m delta -n 2 --slice 0.000001
 */
#include <nx.h>
#include <stdio.h>

enum { N = 4096, MESSAGES = 1000 };
static double a[N], b[N];
static float c[N];
static volatile long handled;
static volatile double sink;
static char box[8];

struct sums {
    double d, e;
    float f;
    long i, k;
    long double x, y;
};

static struct sums sum(long turns)
{
    struct sums s = {0, 1, 0, 0, 1, 0, 1};
    long t, j;
    for (t = 0; t < turns; t++)
        for (j = 0; j < N; j++) {
            a[j] = a[j] * 0.5 + b[j];
            s.d += a[j] * b[j];
            s.e = s.e * 0.999 + b[j];
            c[j] = c[j] * 0.25f + (float)j;
            s.f += c[j];
            s.i += j ^ t;
            s.k = s.k * 31 + j;
            s.x = s.x * 0.75L + (long double)j;
            s.y = s.y * 0.5L + s.x;
        }
    return s;
}

/* A message goes to and fro. */
static void handler(long type, long count, long node, long pid)
{
    long double x = 0;
    double y = 1;
    (void)count, (void)pid;
    for (int i = 0; i < N / 16; i++)
        x += i, y = y * 1.5 + 3, b[i] += 0;
    sink = (double)x + y;
    hrecv(type, box, sizeof box, handler);
    handled++;
    csend(type, 0, 0, node, 0);
}

static void begin(void)
{
    for (int i = 0; i < N; i++)
        a[i] = i, b[i] = 1.0 / (i + 1), c[i] = 0;
}

int main(void)
{
    long rounds = 0, differ = 0, work;
    struct sums alone, now;
    begin();
    alone = sum(2);
    hrecv(1, box, sizeof box, handler);
    if (mynode() == 0)
        csend(1, 0, 0, 1, 0);
    for (; handled < MESSAGES; rounds++) {
        begin();
        now = sum(2);
        differ += now.d != alone.d || now.e != alone.e || now.f != alone.f || now.i != alone.i ||
                  now.k != alone.k || now.x != alone.x || now.y != alone.y;
    }
    gisum(&differ, 1, &work);
    gilow(&rounds, 1, &work);
    if (mynode() == 0)
        printf("%s rounds, %ld differ\n", rounds > 10 ? "many" : "few", differ);
    return 0;
}
