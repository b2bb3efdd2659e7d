/* Selection is by type: a type, any, or a mask; what is not selected stays where it is.
 * run: -m delta -n 2
 */
#include <nx.h>
#include <stdio.h>

int main(void)
{
    static const long types[] = {5, 3, 40, 7, 100000};
    int i;
    char c = 0;
    if (mynode() == 0) {
        for (i = 0; i < 5; i++)
            csend(types[i], &c, 1, 1, 0);
        return 0;
    }
    cprobe(100000); /* all are there */
    crecv(7, &c, 1);
    printf("7 selects %ld\n", infotype());
    crecv((long)(int)(0x80000000u | 1u << 3), &c, 1);
    printf("mask of 3 selects %ld\n", infotype());
    crecv((long)(int)(0x80000000u | 1u << 30), &c, 1);
    printf("mask of 30 and up selects %ld\n", infotype());
    printf("type 9 is %s\n", iprobe(9) ? "there" : "not there");
    crecv(-1, &c, 1);
    printf("any selects %ld\n", infotype());
    crecv(-1, &c, 1);
    printf("any selects %ld\n", infotype());
    return 0;
}
