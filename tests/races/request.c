/* request.c - main asks before it has written what the answer's handler reads: the answer may come first.
 * With CORRECT: main writes what the answer's handler reads, and then asks: the handler runs for the
 * answer, which is sent when the question has been received. No masktrap is needed.
 * variable: scale */
#include <stdio.h>
#include "nx.h"

enum { QUESTION = 5, ANSWER = 6, END = 7 };
static long scale = 1, answer, scaled;

static void on_answer(long type, long count, long node, long pid)
{
    scaled = answer * scale; /* RACE */
    csend(END, NULL, 0, mynode(), 0);
}

int main(void)
{
    long x = 4;

    if (mynode() == 0) {
        hrecv(ANSWER, &answer, sizeof answer, on_answer);
#ifdef CORRECT
        scale = 100;
        csend(QUESTION, &x, sizeof x, 1, 0);
#else
        csend(QUESTION, &x, sizeof x, 1, 0);
        scale = 100; /* RACE */
#endif
        crecv(END, NULL, 0);
        printf("%ld\n", scaled);
    } else {
        crecv(QUESTION, &x, sizeof x);
        x *= x;
        csend(ANSWER, &x, sizeof x, 0, 0);
    }
    return 0;
}
