/* Partners that both send first and then receive never block, at any length; nor does a ring in which all do.
 * run: all
 */
#include <string.h>
#include "rule.h"

enum { LONGEST = 1000000 };
static char out[LONGEST], in[LONGEST];

static int crosses(long partner, long len)
{
    memset(out, (int)(len + mynode()), (size_t)len);
    csend(len, out, len, partner, 0);
    csend(len, out, len, partner, 0);
    crecv(len, in, len);
    crecv(len, in, len);
    return infocount() == len;
}

int main(void)
{
    static const long lengths[] = {0, 1, 100, 101, 5000, LONGEST};
    long me = mynode(), partner = me ^ 1;
    int good = 1;
    if (partner >= numnodes())
        partner = me;
    for (int i = 0; i < 6; i++)
        good = good && crosses(partner, lengths[i]) && infonode() == partner &&
               (lengths[i] == 0 || in[lengths[i] - 1] == (char)(lengths[i] + partner));
    rule("two partners", good);
    for (int i = 0; i < 5; i++) {
        csend(lengths[i], out, lengths[i], next_node(), 0);
        crecv(lengths[i], in, LONGEST);
        good = good && infocount() == lengths[i] && infonode() == last_node();
    }
    rule("a ring", good);
    return 0;
}
