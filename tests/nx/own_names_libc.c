/* A program may have variables and functions of its own by names of the C library; it defines them or leaves
 * them common.
 * compile: -w
 * run: -m ipsc860 -n 2
 */
int index, optind, timezone[3];
double gamma;
char *tzname;

int div(a, b)
int a, b;
{
    return a / b;
}

static char *ctime()
{
    return "mine";
}

int getopt(x)
{
    return x + 1;
}

main()
{
    index = 2;
    optind = getopt(index);
    timezone[2] = div(9, optind);
    gamma = 0.5;
    if (mynode() == 0)
        printf("%d %d %d %g %s %d\n", index, optind, timezone[2], gamma, ctime(), tzname == 0);
    return 0;
}
