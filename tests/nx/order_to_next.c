/* Messages of one type between two nodes arrive in the order sent, whatever their lengths, to one node or to
 * all, received late or early.
 * run: all
 */
#include <string.h>
#include "rule.h"

enum { MESSAGES = 24 };
static const long lengths[] = {4, 5000, 100, 101, 60, 20000};

static void send_all(long to, char *buf)
{
    for (int i = 0; i < MESSAGES; i++) {
        memset(buf, i, 20000);
        csend(3, buf, lengths[i % 6], to, 0);
    }
}

static int all_in_order(char *buf)
{
    int good = 1;
    for (int i = 0; i < MESSAGES; i++) {
        crecv(3, buf, 20000);
        good = good && buf[0] == i && buf[infocount() - 1] == i && infocount() == lengths[i % 6];
    }
    return good;
}

int main(void)
{
    static char out[20000], in[MESSAGES][20000];
    long id[MESSAGES];
    int good = 1;
    send_all(next_node(), out);
    rule("sent first, then received", all_in_order(in[0]));
    for (int i = 0; i < MESSAGES; i++)
        id[i] = irecv(3, in[i], sizeof in[i]);
    send_all(next_node(), out);
    for (int i = MESSAGES - 1; i >= 0; i--) {
        msgwait(id[i]);
        good = good && in[i][0] == i && infocount() == lengths[i % 6];
    }
    rule("received where posted, first to first", good);
    gsync();
    if (mynode() == 0 && numnodes() > 1)
        send_all(-1, out);
    rule("to all others", mynode() == 0 || all_in_order(in[0]));
    return 0;
}
