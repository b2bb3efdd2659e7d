/* The calls with an underscore return -1 and set errno; 0 or more is success.
 * run: -m ipsc860 -n 2
 * run: -m delta -n 2
 */
#include <nx.h>
#include <stdio.h>
#include <string.h>

static char buf[100];

static void expect(const char *what, long result, int error)
{
    if (result != -1 || errno != error)
        printf("%s: %ld, errno %d\n", what, result, errno);
    errno = 0;
}

static void sends(void)
{
    expect("no such node", _csend(1, buf, 1, 2000, 0), EQNODE);
    expect("the host", _isend(1, buf, 1, myhost(), 0), EQNODE);
    expect("type too large", _csend(2000000000, buf, 1, 1, 0), EQTYPE);
    expect("negative type", _csend(-3, buf, 1, 1, 0), EQTYPE);
    expect("negative length", _csend(1, buf, -1, 1, 0), EQLEN);
    expect("null pointer", _csend(1, 0, 1, 1, 0), EQPBUF);
    expect("no handler", _hsend(1, buf, 1, 1, 0, 0), EQHND);
    expect("-1 in a list", _gsendx(1, buf, 1, (const long[]){1, -1}, 2), EQNODE);
    expect("list of -1", _gsendx(1, buf, 1, 0, -1), EQLEN);
}

static void receives(void)
{
    expect("negative length", _crecv(1, buf, -1), EQLEN);
    expect("null pointer", _irecv(1, 0, 1), EQPBUF);
    expect("no handler", _hrecv(1, buf, 1, 0), EQHND);
    expect("no such node", _crecvx(1, buf, 1, 77, 0, 0), EQNODE);
    expect("id not in use", _msgwait(3), EQMID);
    expect("id not in use", _msgdone(-1), EQMID);
    expect("id not in use", _msgcancel(500), EQMID);
    expect("no ids", _msgmerge(-1, -1), EQMID);
    expect("negative pid", _setpid(-5), EQPID);
    expect("no such node", _killproc(9, 0), EQNODE);
    expect("load", _load("x", 1, 0), ENOSYS);
    expect("own end", _waitone(0, 0, 0, 0, 0), EQNOPROC);
    expect("negative n", _gisum(0, -1, 0), EQLEN);
    expect("no work", _gdsum((double *)(void *)buf, 1, 0), EQPBUF);
}

/* A message too long is lost; an id that had it is given back. */
static void too_long(void)
{
    long id = _irecv(5, buf, 3);
    expect("too long", _crecv(4, buf, 3), EQMSGLONG);
    printf("%ld bytes of type %ld, buffer '%s'\n", infocount(), infotype(), buf);
    expect("too long", _msgwait(id), EQMSGLONG);
    expect("given back", _msgwait(id), EQMID);
    printf("then %ld, '%s'\n", _crecv(4, buf, 100), buf);
}

int main(void)
{
    if (mynode() == 1) {
        _csend(4, "long", 5, 0, 0);
        _csend(5, "long", 5, 0, 0);
        printf("%ld %ld\n", _csend(4, "right", 6, 0, 0), _mynode());
        fflush(stdout);
        csend(6, buf, 0, 0, 0);
        return 0;
    }
    crecv(6, buf, 0);
    sends();
    receives();
    too_long();
    errno = EQTYPE;
    puts(strerror(errno));
    csend(-3, buf, 1, 1, 0); /* ends this process with an error */
    return 0;
}
