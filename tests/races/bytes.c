/* bytes.c - main and the handler set bits in one byte; a bit may be lost.
 * With CORRECT: main and the handler set bits in different bytes of one word: bytes are loaded and stored
 * each by itself.
 * variable: marks */
#include <stdio.h>
#include "nx.h"

enum { MARK = 5, ENOUGH = 6, MARKS = 4 };
static unsigned char marks[4], mark, came;

static void on_mark(long type, long count, long node, long pid)
{
    marks[1] |= mark; /* RACE */
    if (++came < MARKS)
        hrecv(MARK, &mark, sizeof mark, on_mark);
    else
        csend(ENOUGH, NULL, 0, mynode(), 0);
}

int main(void)
{
    unsigned char bit;

    if (mynode() == 0) {
        hrecv(MARK, &mark, sizeof mark, on_mark);
        for (bit = 16; bit; bit <<= 1)
#ifdef CORRECT
            marks[2] |= bit;
#else
            marks[1] |= bit; /* RACE */
#endif
        crecv(ENOUGH, NULL, 0);
        printf("%x\n", marks[1] | marks[2]);
    } else {
        for (bit = 1; bit < 1 << MARKS; bit <<= 1)
            csend(MARK, &bit, sizeof bit, 0, 0);
    }
    return 0;
}
