/* NX is declared in every header that programs include, alone or with others; its errno values have their
 * names.
 * run: all
 */
#include <mesh.h>
#include <cube.h>
#include <estat.h>
#include <nx.h>
#include "rule.h"

int main(void)
{
    static const int codes[] = {EQPBUF, EQBLEN,  EQLEN, EQMSGLONG, EQPID,    EQNODE, EQTYPE,  EQMID,
                                EQMEM,  EQNOMID, EQSET, EQNOSET,   EQUSEPID, EQHND,  EQNOPROC};
    int distinct = 1;
    for (int i = 0; i < 15; i++)
        for (int j = 0; j < i; j++)
            distinct = distinct && codes[i] != codes[j] && codes[i] > 0;
    rule("the errno values", distinct);
    rule("a force type, and no process type", FORCE_TYPE == 1 << 30 && INVALID_PTYPE < 0);
    rule("the length of a cube's name", NAMELEN == 32);
    rule("the I/O modes",
         M_UNIX == 0 && M_LOG == 1 && M_SYNC == 2 && M_RECORD == 3 && M_GLOBAL == 4 && M_ASYNC == 5);
    return 0;
}
