/* When csend returns the buffer may be used again, though nobody has received; for isend, when msgwait
 * returns or msgdone answers 1; for hsend, when its handler runs.
 * run: all
 */
#include <string.h>
#include "rule.h"

enum { LONGEST = 40000 };
static char out[LONGEST], in[LONGEST];
static volatile int free_again;

static void sent(long type, long count, long node, long pid)
{
    free_again = type == 8 && count == LONGEST;
    (void)node, (void)pid;
}

static int holds(long type, char what)
{
    memset(out, 'x', sizeof out);
    crecv(type, in, sizeof in);
    for (long i = 0; i < infocount(); i++)
        if (in[i] != what)
            return 0;
    return 1;
}

int main(void)
{
    static const long lengths[] = {1, 100, 101, LONGEST};
    long to = next_node();
    for (int i = 0; i < 4; i++) {
        memset(out, 'a' + i, sizeof out);
        csend(i, out, lengths[i], to, 0);
        memset(out, '?', sizeof out);
    }
    rule("csend", holds(0, 'a') && holds(1, 'b') && holds(2, 'c') && holds(3, 'd'));
    memset(out, 'e', sizeof out);
    msgwait(isend(6, out, LONGEST, to, 0));
    rule("isend and msgwait", holds(6, 'e'));
    memset(out, 'f', sizeof out);
    for (long id = isend(7, out, 100, to, 0); !msgdone(id);)
        ;
    rule("isend and msgdone", holds(7, 'f'));
    memset(out, 'g', sizeof out);
    hsend(8, out, LONGEST, to, 0, sent);
    while (!free_again)
        flick();
    rule("hsend and its handler", holds(8, 'g'));
    return 0;
}
