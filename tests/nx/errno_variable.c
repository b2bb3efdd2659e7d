/* errno as the variable that it was before ANSI C: no header declares it, and each node has its own.
 * compile: -w
 * run: all
 */
extern long errno;
extern int open(), printf(), mynode(), gsync(), gisum();

own()
{
    extern int errno;
    int before = errno, *where = &errno;
    *where += 3;
    gsync();
    return before == 5 + mynode() && errno == 8 + mynode();
}

main()
{
    long good, work;
    good = open("no/such/file", 0) < 0 && errno == 2;
    errno = 5 + mynode();
    gsync();
    good = good && own();
    gisum(&good, 1, &work);
    if (mynode() == 0)
        printf("errno on %s\n", good == numnodes() ? "all nodes" : "some nodes only");
    return 0;
}
