/* msgmerge makes one id of two, msgignore gives an id back when it is complete; both hand all ids back in the
 * end.
 * run: -m ipsc860 -n 2
 * run: -m delta -n 2
 */
#include <nx.h>
#include <stdio.h>

enum { IDS = 500, SIZE = 300 };
static char in[3][SIZE], out[3][SIZE];

/* As many as there are can be had. */
static void take_all(const char *when)
{
    long id[IDS], i, n = 0;
    while (n < IDS && (id[n] = _irecv(99, in[0], 1)) >= 0)
        n++;
    printf("%s: %ld ids\n", when, n);
    for (i = 0; i < n; i++)
        msgcancel(id[i]);
}

int main(void)
{
    long id, i;
    if (mynode() == 1) {
        for (i = 0; i < 3; i++)
            out[i][0] = 'a' + (char)i;
        crecv(7, in[0], 0);
        id = -1;
        for (i = 0; i < 3; i++)
            id = msgmerge(id, isend(i, out[i], 100 * i, 0, 0)); /* a group of three, begun with none */
        msgwait(id);
        for (i = 0; i < 600; i++) {
            msgignore(isend(3, out[i % 3], 1, 0, 0));
            if (i % 100 == 99)
                csend(4, out[0], 0, 0, 0);
        }
        csend(5, out[2], 1, 0, 0);
        csend(8, out[2], 0, 0, 0);
        return 0;
    }
    id = msgmerge(irecv(0, in[0], SIZE), irecv(1, in[1], SIZE));
    id = msgmerge(id, irecv(2, in[2], SIZE));
    printf("nothing was sent: %ld\n", msgdone(id));
    csend(7, out[0], 0, 1, 0);
    msgwait(id);
    printf("all three are here: '%c' '%c' '%c', the last has %ld bytes\n", in[0][0] ? in[0][0] : ' ',
           in[1][0], in[2][0], infocount());
    take_all("after msgmerge");
    for (i = 0; i < 600; i++) {
        msgignore(irecv(3, in[0], SIZE));
        if (i % 100 == 99)
            crecv(4, in[1], 0); /* after it these hundred are here */
    }
    printf("600 ignored: '%c', what infocount says is %ld\n", in[0][0], infocount());
    take_all("after msgignore");
    id = msgmerge(irecv(5, in[0], SIZE), irecv(6, in[1], SIZE));
    msgcancel(id);
    crecv(8, in[1], 0);
    crecv(5, in[2], SIZE);
    printf("cancelled, and received again: '%c'\n", in[2][0]);
    take_all("after msgcancel");
    return 0;
}
