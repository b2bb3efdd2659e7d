/* Programs that are in no deadlock though most nodes wait: the argument says why not. */
#include <nx.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const char *how;
static long word;

static int is(const char *name)
{
    return strcmp(how, name) == 0;
}

static void answer(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)pid;
    csend(6, &word, sizeof word, node, 0);
}

static void wake(int sig)
{
    (void)sig;
    if (write(1, "woken\n", 6) < 0)
        _exit(1);
    _exit(0);
}

/* Without a call, but for the polls that nxcc puts in. */
static void compute(double seconds)
{
    volatile double x = 1;
    for (double begin = dclock(); dclock() - begin < seconds;)
        for (int i = 0; i < 1000000; i++)
            x = x * 1.000001;
}

/* What node 1 does before it sends what node 0 waits for. */
static void delay(void)
{
    char line[80];
    if (is("computes"))
        compute(1);
    else if (is("sleeps"))
        sleep(1);
    else if (is("waits for the system")) {
        FILE *f = popen("sleep 1; echo awake", "r");
        if (!f || !fgets(line, sizeof line, f))
            puts("nothing to read");
    } else if (is("polls")) {
        double begin = dclock();
        while (!iprobe(9) && dclock() - begin < 1)
            flick();
    } else if (is("alarm")) {
        signal(SIGALRM, wake);
        alarm(1);
        crecv(9, &word, sizeof word);
    } else if (is("dies")) {
        killproc(1, 0);
    } else if (is("handles")) {
        hrecv(5, &word, sizeof word, answer);
        compute(1);
    }
}

/* What node 0 waits for. */
static void await(void)
{
    char line[80];
    if (is("alarm") || is("sends much"))
        return;
    if (is("reads")) {
        puts("asks");
        printf("read %s", fgets(line, sizeof line, stdin) ? line : "nothing\n");
        csend(4, &word, sizeof word, 1, 0);
        return;
    }
    if (is("dies")) {
        compute(6); /* longer than a node waits whose others are to end with it */
        return;
    }
    if (is("handles"))
        csend(5, &word, sizeof word, 1, 0);
    crecv(is("handles") ? 6 : 7, &word, sizeof word);
}

/* Long messages of which MPI moves no byte before both sides have looked: they are under way for a long
 * time. */
static void send_much(void)
{
    static char bytes[20000000];
    long next = (mynode() + 1) % numnodes();
    for (int i = 0; i < 20; i++) {
        csend(8, bytes, sizeof bytes, next, 0);
        crecv(8, bytes, sizeof bytes);
        if (i % 5 == 1 + mynode())
            compute(0.2);
    }
}

int main(int argc, char **argv)
{
    how = argc > 1 ? argv[1] : "";
    if (is("sends much"))
        send_much();
    else if (mynode() == 0)
        await();
    else if (mynode() == 1) {
        if (is("reads"))
            crecv(4, &word, sizeof word);
        delay();
        csend(7, &word, sizeof word, 0, 0);
    } else if (mynode() == 2)
        waitall(1, 0);
    if (mynode() == 0)
        puts("done");
    return 0;
}
