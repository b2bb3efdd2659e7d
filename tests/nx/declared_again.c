/* Programs declare NX calls themselves, before the header and after it, with integers of other sizes, as the
 * compilers of the time allowed: the header's types hold.
 * run: all
 */
int mynode(void);
int numnodes();
extern int csendrecv(int, char *, int, int, int, int, char *, int);
extern void msgwait(int);
extern int isend(), irecv();
extern double dclock();
int gsync();
int mypart();
#include "rule.h"
#include <errno.h>
#include <stdlib.h>
int mynode(void);
int mynode();
extern long numnodes(void);
extern long msgdone(int), iprobe(int);
extern void csend(int, char *, int, int, int);
extern int crecv(int, char *, int);
extern long mypart(int *, int *);
extern void hrecv(int, char *, int, void (*)());
extern char *malloc();
extern long errno;

int main(void)
{
    extern int infocount();
    long rows, columns, x = 7 + mynode(), y = 0;
    char *room = malloc(100);
    mypart(&rows, &columns);
    rule("mypart", rows * columns == numnodes());
    csend(5, (char *)&x, sizeof x, (int)next_node(), 0);
    crecv(5, (char *)&y, sizeof y);
    rule("messages", y == 7 + last_node() && infocount() == sizeof y);
    msgwait(irecv(6, room, 100) + 0 * isend(6, room, 100, mynode(), 0));
    rule("results that nobody declares", infocount() == 100);
    rule("_csend to nobody", _csend(1, "a", 1, 9999, 0) == -1 && errno == EQNODE);
    gsync();
    return 0;
}
