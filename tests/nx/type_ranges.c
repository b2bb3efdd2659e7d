/* Types: 0 to 999,999,999 are the program's, 1,073,741,824 to 1,999,999,999 force types, whether written as
 * type | 1 << 30 or as a plain constant; negative ones and those above are errors (EQTYPE).
 * run: all
 */
#include "rule.h"

static int comes_back(long type)
{
    char out = 1, in = 0;
    long id = irecv(type, &in, 1);
    csend(type, &out, 1, mynode(), 0);
    msgwait(id);
    return in == 1 && infotype() == type;
}

static int refused(long type)
{
    char c = 0;
    errno = 0;
    return _csend(type, &c, 1, mynode(), 0) == -1 && errno == EQTYPE &&
           _isend(type, &c, 1, mynode(), 0) == -1;
}

int main(void)
{
    rule("0", comes_back(0));
    rule("999999999", comes_back(999999999));
    rule("1073741824, the first force type", comes_back(1073741824));
    rule("7 | 1 << 30", comes_back(7 | 1 << 30));
    rule("1600000000", comes_back(1600000000));
    rule("1999999999, the last", comes_back(1999999999));
    rule("-1 is none to send", refused(-1));
    rule("nor are others below 0", refused(-5) && refused((long)(int)0x80000000u));
    rule("nor 2000000000 and above", refused(2000000000) && refused(2147483647));
    return 0;
}
