/* A node's 16 MB are enforced: malloc says NULL when they are gone, and gives again what was freed;
 * unexpected messages count, too, and a long one waits for its clear to send until there is room.
 * run: -m delta -n 2
 */
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>

enum { MB = 1 << 20 };

int main(void)
{
    char *block[20], *message;
    int count = 0;
    if (mynode() == 0) {
        while (count < 20 && (block[count] = malloc(MB)))
            count++;
        printf("%s\n", count >= 12 && count < 15 ? "between 12 and 14 MB to be had" : "wrong");
        csend(1, block[0], 0, 1, 0);
        crecv(2, block[0], 0); /* node 1 has begun to send 3 MB: no room for them */
        printf("probe finds %ld\n", iprobe(3));
        free(block[--count]);
        free(block[--count]);
        free(block[--count]);
        free(block[--count]);
        message = malloc(3 * MB);
        crecv(3, message, 3 * MB);
        printf("received %ld, first %d, last %d\n", infocount(), message[0], message[3 * MB - 1]);
    } else {
        long id;
        message = calloc(3, MB);
        message[0] = 1;
        message[3 * MB - 1] = 2;
        crecv(1, message, 0);
        id = isend(3, message, 3 * MB, 0, 0);
        csend(2, message, 0, 0, 0);
        msgwait(id);
    }
    return 0;
}
