/* sizes.c - mallocs each of the sizes it is given, in bytes, touches its last byte, and frees those given as
 * -N again. With -DFIELD=N it has N bytes of its own besides.
 */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

#ifdef FIELD
char field[FIELD] = {1};
#endif

int main(int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        long bytes = atol(argv[i]);
        char *p = malloc((size_t)labs(bytes));
        p[labs(bytes) - 1] = 1;
        if (bytes < 0)
            free(p);
    }
    return 0;
}
