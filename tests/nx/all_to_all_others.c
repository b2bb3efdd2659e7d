/* Node -1 stands for all other nodes: each gets the message once, with its sender; the sender does not. So do
 * empty ones and long ones; with one node nobody does.
 * run: all
 */
#include "rule.h"

static int each_once(long type, long len)
{
    static char buf[3000];
    char from[64] = {0};
    int good = 1;
    for (long i = 1; i < numnodes(); i++) {
        crecv(type, buf, sizeof buf);
        good = good && infocount() == len && !from[infonode()]++ && infonode() != mynode();
        good = good && (len == 0 || (buf[0] == infonode() && buf[len - 1] == infonode()));
    }
    return good;
}

int main(void)
{
    static const long lengths[] = {0, 1, 100, 3000};
    static char buf[3000];
    for (int i = 0; i < 3000; i++)
        buf[i] = (char)mynode();
    for (int i = 0; i < 4; i++)
        csend(i, buf, lengths[i], -1, 0);
    rule("empty", each_once(0, 0));
    rule("of a byte", each_once(1, 1));
    rule("of 100 bytes", each_once(2, 100));
    rule("of 3000 bytes", each_once(3, 3000));
    gsync();
    rule("nothing is left, nor came to the sender", iprobe(-1) == 0);
    return 0;
}
