/* Messages of one type between two nodes arrive in the order sent, short and long mixed, on any machine.
 * run: -m ipsc860 -n 2
 * run: -m delta -n 2
 */
#include <nx.h>
#include <stdio.h>
#include <string.h>

enum { COUNT = 60, TYPE = 4 };
static char buf[4096];

static int length_of(int i)
{
    return i % 3 == 0 ? 4 + 50 * i : 4 + i;
}

int main(void)
{
    int i, number, wrong = 0;
    for (i = 0; i < COUNT; i++) {
        if (mynode() == 0) {
            memcpy(buf, &i, sizeof i);
            csend(TYPE, buf, length_of(i), 1, 0);
        } else {
            crecv(TYPE, buf, sizeof buf);
            memcpy(&number, buf, sizeof number);
            wrong += number != i || infocount() != length_of(i) || infonode() != 0 || infotype() != TYPE;
        }
    }
    if (mynode() == 1)
        printf("%d messages, %d wrong\n", COUNT, wrong);
    return 0;
}
