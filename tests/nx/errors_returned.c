/* With an underscore before its name a call returns -1 and sets errno where the plain one ends the process; 0
 * or more is success. Nodes that are not there, lengths, types, pointers, handlers and ids that are none.
 * run: all
 */
#include "rule.h"

static char buf[16];

static int is(long result, int error)
{
    int good = result == -1 && errno == error;
    errno = 0;
    return good;
}

int main(void)
{
    long nodes = numnodes(), list[] = {0, nodes + 5};
    rule("sends to nodes that are not there",
         is(_csend(1, buf, 1, nodes + 1, 0), EQNODE) && is(_isend(1, buf, 1, 100000, 0), EQNODE) &&
             is(_csend(1, buf, 1, -2, 0), EQNODE) && is(_gsendx(1, buf, 1, list, 2), EQNODE) &&
             is(_csendrecv(1, buf, 1, nodes + 1, 0, 1, buf, 1), EQNODE));
    rule("to the host, where no host program runs", is(_csend(1, buf, 1, myhost(), 0), EQNODE));
    rule("receives from them", is(_crecvx(1, buf, 1, nodes + 1, -1, 0), EQNODE) &&
                                   is(_irecvx(1, buf, 1, -2, -1, 0), EQNODE) &&
                                   is(_iprobex(1, 5000, -1, 0), EQNODE));
    rule("lengths", is(_csend(1, buf, -1, 0, 0), EQLEN) && is(_crecv(1, buf, -4), EQLEN) &&
                        is(_irecv(1, buf, -1), EQLEN) && is(_gsendx(1, buf, 1, list, -1), EQLEN));
    rule("pointers",
         is(_csend(1, 0, 1, 0, 0), EQPBUF) && is(_irecv(1, 0, 1), EQPBUF) && is(_mypart(0, 0), EQPBUF));
    rule("handlers", is(_hrecv(1, buf, 1, 0), EQHND) && is(_hsend(1, buf, 1, 0, 0, 0), EQHND));
    rule("ids", is(_msgwait(3), EQMID) && is(_msgcancel(-7), EQMID) && is(_msgignore(100000), EQMID) &&
                    is(_msgmerge(-1, -1), EQMID));
    rule("process types", is(_setptype(-1), EQPID) && is(_setpid(-9), EQPID));
    rule("global operations", is(_gisum(0, 3, 0), EQPBUF) && is(_gdsum(0, -1, 0), EQLEN) &&
                                  is(_gopf(buf, 1, buf, 0), EQHND) && is(_gcolx(buf, 0, buf), EQPBUF));
    rule("0 or more is success", _csend(1, buf, 3, mynode(), 0) >= 0 && _crecv(1, buf, 3) >= 0 &&
                                     _infocount() == 3 && _mynode() == mynode() && _gsync() >= 0 &&
                                     _flick() >= 0 && _masktrap(0) == 0);
    return 0;
}
