/* A receive buffer shorter than the message is an error, EQMSGLONG, in crecv and in what completes an irecv.
 * The message is lost, the buffer is unchanged, and the program continues.
 * run: all
 */
#include <string.h>
#include "rule.h"

static char buf[8] = "before", out[300] = "a message of three hundred bytes";

static int too_long(long result)
{
    int good = result == -1 && errno == EQMSGLONG && strcmp(buf, "before") == 0;
    errno = 0;
    return good;
}

int main(void)
{
    long id, info[8], to = next_node();
    for (int i = 0; i < 6; i++)
        csend(i, out, i % 2 ? 300 : 9, to, 0);
    rule("crecv, a short message", too_long(_crecv(0, buf, 8)));
    rule("crecv, a long one", too_long(_crecv(1, buf, 8)));
    rule("crecvx", too_long(_crecvx(2, buf, 8, -1, -1, info)));
    id = irecv(3, buf, 8);
    rule("msgwait", too_long(_msgwait(id)));
    rule("the id is given back", _msgwait(id) == -1 && errno == EQMID);
    id = irecv(4, buf, 8);
    cprobe(5);
    rule("msgdone", too_long(_msgdone(id)));
    rule("csendrecv", too_long(_csendrecv(6, out, 9, mynode(), 0, 6, buf, 8)));
    crecv(5, out, sizeof out);
    rule("a buffer just long enough", infocount() == 300);
    rule("none is left", iprobe(-1) == 0);
    return 0;
}
