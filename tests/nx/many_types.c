/* With thousands of messages waiting, each receive takes the first that it selects: of a type, of a type and
 * a node, of any type. The receiver keeps a plain list of what has been sent, and compares.
 * run: -m ipsc860 -n 4
 * run: -m paragon -n 3
 */
#include "rule.h"
#include <stdlib.h>
#include <string.h>

enum { EACH = 1500, TYPES = 300, SENDERS = 3 };
static struct sent {
    long type, node, number, taken;
} sent[SENDERS * EACH];

static unsigned long state = 12345;
static long below(long n)
{
    state = (state * 1103515245 + 12345) & 0x7fffffff;
    return (long)(state >> 8) % n;
}

/* The senders take turns, so that the order in which their messages come is known: the next begins when
 * node 0 has got the last one's last message, which comes behind all others of that sender. (A gsync alone
 * says nothing of when messages come.) */
static void send_all(long count)
{
    for (long i = 0; i < count; i++) {
        long type = below(TYPES), node = 1 + i / EACH;
        sent[i] = (struct sent){type, node, i, 0};
        if (mynode() == node)
            csend(type, &i, sizeof i, 0, 0);
        if (i % EACH == EACH - 1 && mynode() == node)
            csend(TYPES, NULL, 0, 0, 0);
        if (i % EACH == EACH - 1 && mynode() == 0)
            crecv(TYPES, NULL, 0);
        if (i % EACH == EACH - 1)
            gsync();
    }
}

static const struct sent *first(long type, long node, long count)
{
    for (long i = 0; i < count; i++)
        if (!sent[i].taken && (type < 0 || sent[i].type == type) && (node < 0 || sent[i].node == node)) {
            sent[i].taken = 1;
            return &sent[i];
        }
    return NULL;
}

int main(void)
{
    long count = (numnodes() - 1 < SENDERS ? numnodes() - 1 : SENDERS) * EACH, wrong = 0, number, info[8];
    send_all(count);
    for (long i = 0; i < count && mynode() == 0; i++) {
        long type = i % 5 == 0 ? -1 : below(TYPES), node = i % 7 == 0 ? 1 + below(SENDERS) : -1;
        const struct sent *right = first(type, node, count);
        if (!right != !iprobex(type, node, -1, info)) {
            wrong++;
        } else if (right) {
            crecvx(type, &number, sizeof number, node, -1, info);
            wrong += number != right->number || infotype() != right->type || infonode() != right->node;
        }
    }
    rule("each receive takes the first that it selects", wrong == 0);
    return 0;
}
