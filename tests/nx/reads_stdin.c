/* The standard input goes to node 0; others find it at its end.
 * stdin: 12 monkeys
 * run: all
 */
#include "rule.h"

int main(void)
{
    int n = 0, got;
    char word[20] = "";
    got = mynode() == 0 ? scanf("%d %19s", &n, word) : getchar();
    rule("node 0 reads it", mynode() != 0 || (got == 2 && n == 12 && word[6] == 's'));
    rule("the others find nothing", mynode() == 0 || got == EOF);
    return 0;
}
