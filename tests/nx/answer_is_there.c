/* csendrecv goes on at once when the answer has come before it asks; what it sends is received, and gone,
 * long before the node makes another call.
 * run: -m ipsc860 -n 8
 * run: -m delta -n 3
 * run: -m paragon -n 3
 */
#include "rule.h"

enum { ANSWER = 5, QUESTION, LAST, STEPS = 100000 };
static volatile double sink;

static void work(int steps)
{
    for (int i = 1; i <= steps; i++)
        sink += 1.0 / i;
}

int main(void)
{
    int number = (int)mynode(), got = -1, last = -1;
    gsync();
    if (mynode() == 0) {
        work(STEPS / 10);
        csendrecv(QUESTION, &number, sizeof number, 2, 0, ANSWER, &got, sizeof got);
        work(STEPS);
        crecv(LAST, &last, sizeof last);
    } else if (mynode() == 1) {
        csend(ANSWER, &number, sizeof number, 0, 0);
    } else if (mynode() == 2) {
        crecv(QUESTION, &got, sizeof got);
        work(STEPS / 10);
        csend(LAST, &number, sizeof number, 0, 0);
    }
    rule("all have what was sent", mynode() == 0 ? got == 1 && last == 2 : mynode() != 2 || got == 0);
    return 0;
}
