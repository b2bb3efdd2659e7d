/* Message ids, from 1 on: irecv and isend give them out, msgwait, msgdone and msgcancel give them back; there
 * are a limited number.
 * run: -m delta -n 2
 */
#include <nx.h>
#include <stdio.h>

int main(void)
{
    static char in[8], out[8] = "abcdefg";
    long id[500], polls = 0;
    int i;
    if (mynode() == 0) {
        for (i = 0; i < 100; i++)
            id[i] = isend(1, out, 8, 1, 0);
        for (i = 0; i < 100; i++)
            msgwait(id[i]);
        crecv(2, in, 8);
        return 0;
    }
    for (i = 0; i < 500; i++)
        id[i] = irecv(i < 100 ? 1 : 3, in, 8);
    for (i = 0; i < 99; i++)
        msgwait(id[i]);
    while (!msgdone(id[99]))
        polls++;
    printf("ids begin at 1: %s\n", id[0] == 1 ? "yes" : "no");
    printf("got %s, %ld bytes of type %ld\n", in, infocount(), infotype());
    for (i = 100; i < 500; i++)
        msgcancel(id[i]);
    for (i = 0; i < 500; i++)
        id[i] = irecv(3, in, 8);
    printf("all 500 again\n");
    csend(2, out, 0, 0, 0);
    irecv(3, in, 8); /* one too many: ends this process with an error */
    return 0;
}
