/* torus.h - the torus of the pattern halo, as square as can be: a node's neighbours in the east, west, south
 * and north. What goes to to[k] comes from to[k ^ 1]. */
#ifndef TRAFFIC_TORUS_H
#define TRAFFIC_TORUS_H

static void torus_neighbours(long me, long count, long to[4])
{
    long rows = 1;
    while ((rows + 1) * (rows + 1) <= count)
        rows++;
    while (count % rows)
        rows--;
    long columns = count / rows, x = me % columns, y = me / columns;
    to[0] = y * columns + (x + 1) % columns, to[1] = y * columns + (x + columns - 1) % columns;
    to[2] = (y + 1) % rows * columns + x, to[3] = (y + rows - 1) % rows * columns + x;
}

#endif
