/* The same without any header, as many programs have it.
 * compile: -w
 * run: -m ipsc860 -n 2
 * run: -m paragon -n 3
 */
extern bcopy();
extern int bzero(), bcmp();
extern char *index(), *rindex();
char a[16] = "abcabc", b[16];

main(argc, argv) char **argv;
{
    int n = 16;
    bzero(b, n);
    bcopy(a, b, n);
    if (mynode() == 0)
        printf("%d %s %s %d\n", bcmp(a, b, n), index(b, 'b'), rindex(b, 'b'), ffs(n));
    exit(0);
}
