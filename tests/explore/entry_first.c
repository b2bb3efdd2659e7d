/* entry_first.c - node 1 sends the size of a table, node 2 an entry for it, and node 0 receives both with
 * one typesel for any type. It counts on the size to come first.
 *
 * bad outcome: crash of node 0, which stores through a null pointer, when the entry comes before the size
 * depth: 1 (entry < size)      nodes: 3
 * good: the line "table of 4, entry 7"
 * delay: node 1's message by more than 150 us */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"
#include "work.h"

enum { SIZE = 5, ENTRY = 6 };

static void collect(void)
{
    long *table = NULL, size = 0, message;
    int i;

    for (i = 0; i < 2; i++) {
        crecv(-1, &message, sizeof message);
        if (infotype() == SIZE)
            table = malloc((size = message) * sizeof *table);
        else
            table[0] = message;
    }
    printf("table of %ld, entry %ld\n", size, table[0]);
}

int main(void)
{
    long size = 4, entry = 7;

    if (mynode() == 0) {
        collect();
    } else if (mynode() == 1) {
        late(1);
        csend(SIZE, &size, sizeof size, 0, 0);
    } else {
        work(150);
        csend(ENTRY, &entry, sizeof entry, 0, 0);
    }
    return 0;
}
