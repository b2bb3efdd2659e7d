/* hrecv serves one message; the next of its type wait for a receive. A handler gets type, count, node and
 * ptype; infocount() and so on describe its message inside, and outside keep describing the program's. It
 * may send, and post itself again.
 * run: all
 */
#include <string.h>
#include "rule.h"

static char box[200];
static volatile int once, again, answered;
static int described, all;

static void count_once(long type, long count, long node, long pid)
{
    described = type == 1 && count == 10 && node == last_node() && pid == 0 && infotype() == 1 &&
                infocount() == 10 && infonode() == node && infopid() == 0 && strcmp(box, "nine byte") == 0;
    once++;
}

static void count_again(long type, long count, long node, long pid)
{
    if (++again < 5)
        hrecv(2, box, sizeof box, count_again);
    all += (int)count;
    (void)type, (void)node, (void)pid;
}

static void answer(long type, long count, long node, long pid)
{
    csend(4, box, count, node, pid);
    answered++;
    (void)type;
}

int main(void)
{
    char buf[200];
    hrecv(1, box, sizeof box, count_once);
    gsync();
    for (int i = 0; i < 3; i++)
        csend(1, "nine byte", 10, next_node(), 0);
    crecv(1, buf, sizeof buf);
    crecv(1, buf, sizeof buf);
    rule("one message is handled, the others are received", once == 1 && iprobe(1) == 0);
    rule("its arguments and infocount() describe it", described);

    hrecv(2, box, sizeof box, count_again);
    gsync();
    for (int i = 1; i <= 6; i++)
        csend(2, buf, i, next_node(), 0);
    while (again < 5)
        flick(); /* the program continues between two handlers */
    cprobe(2);
    rule("a handler that posts itself again gets the next", again == 5 && all == 1 + 2 + 3 + 4 + 5);
    crecv(2, buf, sizeof buf);
    rule("until it does not", infocount() == 6 && again == 5);

    csend(9, buf, 7, mynode(), 0);
    crecv(9, buf, sizeof buf);
    hrecv(3, box, sizeof box, answer);
    gsync(); /* its messages are none of the program's */
    csend(9, buf, 8, mynode(), 0);
    cprobe(9);
    csend(3, "a question", 11, next_node(), 0);
    while (!answered)
        flick();
    rule("infocount() is the program's again after a handler", infocount() == 8 && infotype() == 9);
    crecv(9, buf, sizeof buf);
    crecv(4, buf, sizeof buf);
    rule("a handler may send", strcmp(buf, "a question") == 0 && infonode() == next_node());
    return 0;
}
