/* Message ids are limited in number (EQNOMID when there is none) and given back by msgwait, by msgdone when
 * it answers 1, by msgcancel, and after msgignore on completion; after an error too. So any number of them
 * can be used one after another.
 * run: all
 */
#include <string.h>
#include "rule.h"

enum { TIMES = 1000 }; /* more than there are */
static char in[8], out[8] = "message";
static long all;

static long ids(void)
{
    static long id[100000];
    long n = 0;
    errno = 0;
    while (n < 100000 && (id[n] = _irecv(6, in, 8)) >= 0)
        n++;
    if (errno != EQNOMID || _isend(6, out, 8, mynode(), 0) != -1 || errno != EQNOMID)
        return -1;
    for (long i = 0; i < n; i++)
        msgcancel(id[i]);
    return n;
}

static int waits(void)
{
    for (int i = 0; i < TIMES; i++) {
        long s = isend(1, out, 8, mynode(), 0), r = irecv(1, in, 8);
        msgwait(s), msgwait(r);
    }
    return strcmp(in, "message") == 0;
}

static int asks(void)
{
    for (int i = 0; i < TIMES; i++) {
        long r = irecv(2, in, 8);
        csend(2, out, 8, mynode(), 0);
        while (!msgdone(r))
            ;
    }
    return infocount() == 8;
}

static int cancels(void)
{
    for (int i = 0; i < TIMES; i++)
        msgcancel(irecv(3, in, 8));
    csend(3, out, 4, mynode(), 0); /* to nobody who was cancelled */
    crecv(3, in, 8);
    return infocount() == 4 && ids() == all;
}

static int ignores(void)
{
    for (int i = 0; i < TIMES; i++) {
        msgignore(irecv(4, in, 8));
        csend(4, out, 8, mynode(), 0);
        while (iprobe(4)) /* time passes */
            ;
        if (i % 50 == 49) /* all are complete */
            for (double since = dclock(); dclock() < since + 0.01;)
                ;
    }
    return 1;
}

static int fails(void)
{
    int good = 1;
    for (int i = 0; i < 600; i++) {
        long r = irecv(5, in, 4);
        csend(5, out, 8, mynode(), 0);
        good = good && _msgwait(r) == -1 && errno == EQMSGLONG;
    }
    return good;
}

static int are_limited(void)
{
    return ids() >= 100 && all < TIMES && waits();
}

int main(void)
{
    all = ids();
    rule("msgwait gives back", waits());
    rule("msgdone gives back", asks());
    rule("msgcancel gives back", cancels());
    rule("msgignore gives back", ignores());
    rule("an error gives back", fails());
    rule("there are not more than so many", are_limited());
    rule("an id that is not in use is an error", _msgwait(7) == -1 && errno == EQMID && _msgdone(-3) == -1);
    return 0;
}
