/* gcolx, gcol and gopf take lengths in bytes, of any size, 0 too, different from node to node; on any number
 * of nodes. gopf combines with any operation that is associative and commutative.
 * run: all
 */
#include <string.h>
#include "rule.h"

struct place { /* of 9 bytes */
    int value;
    int node;
    char mark;
} __attribute__((packed));

/* The largest value, and the lowest node that has it. */
static long largest(void *a, void *b)
{
    struct place *x = a, *y = b;
    if (y->value > x->value || (y->value == x->value && y->node < x->node))
        *x = *y;
    return 0;
}

int main(void)
{
    static char mine[100], all[40 * 100];
    long lens[64], me = mynode(), nodes = numnodes(), at = 0, total;
    int good = 1;
    struct place place = {(int)(me * 5 % 8), (int)me, (char)('A' + me % 8)}, work;
    memset(mine, 'a' + (int)me % 26, sizeof mine);
    for (long i = 0; i < nodes; i++)
        lens[i] = i * 7 % 23;
    gcolx(mine, lens, all);
    for (long i = 0; i < nodes; i++)
        for (long j = 0; j < lens[i]; j++)
            good = good && all[at++] == 'a' + i % 26;
    rule("gcolx", good);
    memset(all, 0, sizeof all);
    gcol(mine, lens[me], all, sizeof all, &total);
    rule("gcol says how many bytes", total == at && all[at] == 0);
    at = 0;
    for (long i = 0; i < nodes; i++)
        for (long j = 0; j < lens[i]; j++)
            good = good && all[at++] == 'a' + i % 26;
    rule("gcol", good);
    gopf(&place, sizeof place, &work, largest);
    rule("gopf", place.node == (nodes > 3 ? 3 : nodes > 1) && place.value == place.node * 5 % 8 &&
                     place.mark == 'A' + place.node);
    rule("too many bytes for the room",
         nodes == 1 || (_gcol(mine, 10, all, 10, &total) == -1 && errno == EQBLEN));
    return 0;
}
