/* hwclock counts ticks of 10 MHz, on the Paragon of 50 MHz; dclock and mclock tell the same time.
 * run: -m ipsc860 -n 2
 * run: -m delta -n 2
 * run: -m paragon -n 2
 */
#include <nx.h>
#include <stdio.h>
#include <unistd.h>

int main(void)
{
    esize_t a, b, per_second;
    double begin, end;
    long mhz;
    begin = dclock();
    hwclock(&a);
    usleep(1900000); /* to ask the time all the while would take a processor's */
    while (dclock() < begin + 2)
        ;
    hwclock(&b);
    end = dclock();
    per_second = esub(b, a);
    mhz = (long)((double)ediv(per_second, 100) / (end - begin) / 1e4 + 0.5);
    if (mynode() == 0)
        printf("%s, mclock is %s\n", mhz == 10 || mhz == 50 ? "ticks are right" : "ticks are wrong",
               mclock() / 1000 == (unsigned long)end ? "right" : "wrong");
    return 0;
}
