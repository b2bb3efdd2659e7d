/* No send waits for a receive: all nodes send all others 10,000 short messages and ten of a megabyte, and
 * only then receive them, the long ones first. */
#include <nx.h>
#include <stdio.h>
#include <string.h>

enum { SHORT = 10000, LONG = 10, BYTES = 1 << 20 };
static char buf[BYTES];

int main(void)
{
    long me = mynode(), n = numnodes(), i, k, wrong = 0, work;
    for (k = 0; k < n; k++)
        for (i = 0; k != me && i < SHORT; i++) {
            csend(1000 + me, &i, sizeof i, k, 0);
            if (i % (SHORT / LONG) == 0) {
                memset(buf, (int)(i + me), BYTES);
                csend(2000 + me, buf, BYTES, k, 0);
            }
        }
    for (k = 0; k < n; k++)
        for (i = 0; k != me && i < LONG; i++) {
            crecv(2000 + k, buf, BYTES);
            wrong +=
                infocount() != BYTES || buf[0] != (char)(i * (SHORT / LONG) + k) || buf[BYTES - 1] != buf[0];
        }
    for (k = 0; k < n; k++)
        for (i = 0; k != me && i < SHORT; i++) {
            long got;
            crecv(1000 + k, &got, sizeof got);
            wrong += got != i;
        }
    gisum(&wrong, 1, &work);
    if (me == 0)
        printf("%ld wrong\n", wrong);
    return 0;
}
