/* The extended arithmetic: 64 bits, signed.
 * again: --long32
 * run: -m ipsc860 -n 1
 */
#include <nx.h>
#include <stdio.h>

static void show(const char *what, esize_t a)
{
    char s[21];
    etos(a, s);
    printf("%s %s\n", what, s);
}

int main(void)
{
    esize_t big = stoe("6000000000"), one = {1, 0}, least = stoe("-9223372036854775808");
    printf("slow %ld shigh %ld\n", big.slow, big.shigh);
    show("eadd", eadd(big, one));
    show("esub", esub(one, big));
    show("emul", emul(big, -3));
    show("least", least);
    printf("ediv %ld emod %ld, of negative %ld %ld\n", ediv(big, 7), emod(big, 7), ediv(esub(one, big), 7),
           emod(esub(one, big), 7));
    printf("ecmp %ld %ld %ld\n", ecmp(one, big), ecmp(big, big), ecmp(one, least));
    printf("errors");
    errno = 0, _eadd(least, least), printf(" %d", errno == ERANGE);
    errno = 0, _emul(least, 2), printf(" %d", errno == ERANGE);
    errno = 0, _ediv(big, 1), printf(" %d", errno == ERANGE);
    errno = 0, _ediv(least, -1), printf(" %d", errno == ERANGE);
    errno = 0, _emod(big, 0), printf(" %d", errno == EINVAL);
    errno = 0, _stoe("12x"), printf(" %d", errno == ERANGE);
    errno = 0, _stoe("9223372036854775808"), printf(" %d\n", errno == ERANGE);
    ediv(big, 0); /* ends this process with an error */
    return 0;
}
