/* typesel: a type of 0 or more selects that type; -1 any; other negative values are a mask, whose bits 0 to
 * 29 select the types 0 to 29, and bit 30 all from 30 up, force types too. The messages of a type keep their
 * order.
 * run: all
 */
#include "rule.h"

#define MASK(bits) ((long)(int)(0x80000000u | (bits)))

static long received(long typesel)
{
    char c;
    crecv(typesel, &c, 1);
    return infotype();
}

int main(void)
{
    static const long types[] = {5, 0, 29, 30, 7, 999999999, 12, 31};
    long me = mynode(), posted;
    char c = 0, forced;
    posted =
        irecv(MASK(1u << 30), &forced, 1); /* for the force type: it takes the first that its mask selects */
    csend(0x40000000 | 9, &c, 1, me, 0);
    msgwait(posted);
    rule("bit 30 selects force types", infotype() == (0x40000000 | 9));
    for (int i = 0; i < 8; i++)
        csend(types[i], &c, 1, me, 0);
    cprobe(31);
    rule("a type that was not sent is not there", iprobe(6) == 0 && iprobe(MASK(1u << 6 | 1u << 28)) == 0);
    rule("a type selects itself", received(7) == 7);
    rule("so does type 0", received(0) == 0);
    rule("bit 30 selects the first of 30 and up", received(MASK(1u << 30)) == 30);
    rule("a mask of several selects the first of them", received(MASK(1u << 29 | 1u << 12)) == 29);
    rule("bits 12 and 30: the first of both", received(MASK(1u << 12 | 1u << 30)) == 999999999);
    rule("-1 selects the first of all", received(-1) == 5 && received(-1) == 12 && received(-1) == 31);
    rule("all are gone", iprobe(-1) == 0);
    return 0;
}
