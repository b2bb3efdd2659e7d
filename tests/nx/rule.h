/* rule.h - for the programs of this folder that print the same on any number of nodes. All nodes call rule();
 * node 0 says whether it holds on all of them, and those where it does not say so, too. */
#ifndef RULE_H
#define RULE_H
#include <nx.h>
#include <stdio.h>

static inline void rule(const char *text, int holds)
{
    long broken = !holds, work;
    if (!holds)
        printf("node %ld: %s: NO\n", mynode(), text);
    gisum(&broken, 1, &work);
    if (mynode() == 0)
        printf("%s: %s\n", text, broken ? "NO" : "yes");
}

/* The neighbours in the ring of all nodes. */
static inline long next_node(void)
{
    return (mynode() + 1) % numnodes();
}

static inline long last_node(void)
{
    return (mynode() + numnodes() - 1) % numnodes();
}

#endif
