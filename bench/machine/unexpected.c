/* Unexpected messages: node 0 sends several; node 1 receives when system buffers hold all of them. Time of a
 * crecv over the length, which is the time of the call and of the copying.
 */
#include "bench.h"

enum { TYPE = 1, LAST, MESSAGES = 8, LARGEST = 1 << 19 };

static const long sizes[] = {0, 16, 100, 256, 1024, 4096, 16384, 65536, 262144, LARGEST};
static char buf[LARGEST];

static double receive_us(long bytes)
{
    if (mynode() == 0) {
        for (int i = 0; i < MESSAGES; i++)
            csend(TYPE, buf, bytes, 1, 0);
        csend(LAST, buf, 0, 1, 0);
        crecv(LAST, buf, 0);
        return 0;
    }
    crecv(LAST, buf, 0);
    double begin = now_us();
    for (int i = 0; i < MESSAGES; i++)
        crecv(TYPE, buf, bytes);
    double us = (now_us() - begin) / MESSAGES;
    csend(LAST, buf, 0, 0, 0);
    return us;
}

int main(void)
{
    double us[COUNT(sizes)];
    for (int i = 0; i < COUNT(sizes); i++) {
        us[i] = receive_us(sizes[i]);
        if (mynode() == 1)
            printf("point unexpected %ld %.4f\n", sizes[i], us[i]);
    }
    int last = COUNT(sizes) - 1;
    if (mynode() == 1)
        figure("copy_us_per_byte", (us[last] - us[0]) / (double)sizes[last]);
    return 0;
}
