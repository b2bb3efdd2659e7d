/* A program whose handlers follow each other without a gap makes progress: it computes, makes calls, waits,
 * and unmasks handlers, while the other nodes send requests without end.
 * simulator only: how much is served meanwhile is the host's business otherwise
 * run: -m ipsc860 -n 8
 * run: -m delta -n 8
 * run: -m paragon -n 8
 * run: -m cluster2026 -n 8
 */
#include <nx.h>
#include <stdio.h>

enum { ASK = 1, ANSWER, SELF };
static long question;
static volatile long done, asked;

static void answer(long type, long count, long node, long pid)
{
    long old = masktrap(1), told = done;
    asked++;
    csend(ANSWER, &told, sizeof told, node, 0);
    hrecv(ASK, &question, sizeof question, answer);
    masktrap(old);
    (void)type, (void)count, (void)pid;
}

static void say(const char *what, long before)
{
    printf("%s, and others were served meanwhile: %s\n", what, asked > before ? "yes" : "no");
}

static void go_on(void)
{
    long before = asked, i;
    volatile double sum = 0;
    for (i = 1; i <= 20000; i++)
        sum += 1.0 / (double)i;
    say("it computes", before);
    for (before = asked, i = 0; i < 200; i++)
        iprobe(SELF);
    say("it makes calls", before);
    for (before = asked, i = 0; i < 100; i++) {
        long id = irecv(SELF, (void *)&sum, sizeof sum);
        csend(SELF, (void *)&sum, sizeof sum, mynode(), 0);
        msgwait(id);
    }
    say("it waits", before);
    for (before = asked, i = 0; i < 100; i++) {
        long old = masktrap(1);
        sum += 1;
        masktrap(old);
    }
    say("it holds handlers back", before);
}

int main(void)
{
    long told = 0;
    if (mynode() == 0)
        hrecv(ASK, &question, sizeof question, answer);
    gsync();
    if (mynode() == 0) {
        go_on();
        done = 1;
    }
    while (mynode() > 0 && !told) {
        csend(ASK, &told, sizeof told, 0, 0);
        crecv(ANSWER, &told, sizeof told);
    }
    gsync();
    return 0;
}
