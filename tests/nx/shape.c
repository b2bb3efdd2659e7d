/* What a program may ask of the machine: its number, the number of nodes, the cube's dimension, the shape of
 * the submesh, the host's number; and Gray codes, in which neighbours differ in one bit.
 * run: all
 */
#include "rule.h"

int main(void)
{
    long nodes = numnodes(), rows = 0, columns = 0, r = 0, c = 0, d = nodedim(), bits = 0, sum = mynode(),
         work;
    int good = 1;
    gisum(&sum, 1, &work);
    rule("nodes are numbered from 0", mynode() >= 0 && mynode() < nodes && sum == nodes * (nodes - 1) / 2);
    rule("the dimension", (1 << d) >= nodes && (d == 0 || (1 << (d - 1)) < nodes));
    mypart(&rows, &columns);
    nx_app_rect(&r, &c);
    rule("the shape", rows > 0 && rows * columns == nodes && r == rows && c == columns);
    rule("the host is none of the nodes", myhost() < 0 || myhost() >= nodes);
    rule("the process", mypid() == 0 && myptype() == 0);
    for (long i = 0; i < 1000; i++) {
        long change = gray(i) ^ gray(i + 1);
        bits |= gray(i);
        good = good && ginv(gray(i)) == i && (change & (change - 1)) == 0;
    }
    rule("gray and ginv", good && bits == 1023);
    led(1);
    led(0);
    return 0;
}
