/* message_race.c - a result that depends on which of two messages comes first.
 *
 *    nxcc -g -O2 -o message_race message_race.c
 *    touchstone run -n 3 message_race
 *
 * Two workers, nodes 1 and 2, compute two parts of a polynomial's value; node 0 puts them together. It
 * takes the first message that comes for node 1's part, and the second for node 2's: crecv selects by type
 * alone, and both parts have one type. In the usual timing node 1 is done first, since its part has fewer
 * terms, and all is well. When node 1 is late, the parts are exchanged, and the result is wrong, without a
 * word.
 *
 * The remedy: a type for each part (PART + mynode()), or crecvx, which selects the sender, too. */
#include <stdio.h>
#include <nx.h>

enum { PART = 3, TERMS = 400 };

/* The terms first, first + 1 ... of 1 + x + x^2 + ... divided by x^first. */
static double part(double x, int first, int end)
{
    double sum = 0, power = 1;

    for (; first < end; first++, power *= x)
        sum += power;
    return sum;
}

int main(void)
{
    double x = 0.99, low, high, mine, power = 1;
    int cut = TERMS * 2 / 5, i;

    if (mynode() == 0) {
        crecv(PART, &low, sizeof low);   /* from node 1, it is hoped */
        crecv(PART, &high, sizeof high); /* from node 2 */
        for (i = 0; i < cut; i++)
            power *= x;
        printf("sum of %d terms: %.6f\n", TERMS, low + power * high);
    } else if (mynode() <= 2) {
        mine = mynode() == 1 ? part(x, 0, cut) : part(x, cut, TERMS);
        csend(PART, &mine, sizeof mine, 0, 0);
    }
    return 0;
}
