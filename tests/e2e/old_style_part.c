/* old_style_part.c - the other file of old_style.c: it includes nothing, so that every call is implicitly
 * declared. */
int me, nodes;
char buffer[128];

give(node, length)
{
    register n = length;
    csend(7, buffer, n, node, 0);
    return n;
}

take()
{
    int id = irecv(-1, buffer, sizeof buffer);
    while (!msgdone(id))
        ;
    if (infocount() != me * 3 || infotype() != 7)
        printf("node %d: wrong\n", me);
    if (_csend(7, buffer, -1, -1, 0) != -1)
        printf("node %d: wrong\n", me);
}
