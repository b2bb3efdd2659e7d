/* part_file.c - writes and reads files of polygons; see part_file.h. */
#include <nx.h>
#include "fail.h"
#include "part_file.h"

void part_name(char *name, const char *prefix, int surface, int node)
{
    snprintf(name, PART_NAME_SIZE, "%s_%d.node%d.part", prefix, surface, node);
}

FILE *part_begin(const char *prefix, int surface, int node)
{
    char name[PART_NAME_SIZE];
    FILE *part;
    long old = masktrap(1);

    part_name(name, prefix, surface, node);
    part = fopen(name, "wb");
    masktrap(old);
    if (!part)
        fail("cannot write %s", name);
    return part;
}

static void write_floats(FILE *part, const float *numbers, int n)
{
    if ((int)fwrite(numbers, sizeof *numbers, n, part) != n)
        fail("cannot write a part file: is the disk full?");
}

void part_write(FILE *part, const double *polygons, int doubles)
{
    static float single[1024];
    int i, n;

    for (; doubles > 0; doubles -= n, polygons += n) {
        n = doubles < 1024 ? doubles : 1024;
        for (i = 0; i < n; i++)
            single[i] = (float)polygons[i];
        write_floats(part, single, n);
    }
}

void part_end(FILE *part)
{
    if (fclose(part))
        fail("cannot write a part file: is the disk full?");
}

void part_write_polygon(FILE *part, const struct part_polygon *p)
{
    float head = (float)(p->n + PART_NODE * p->node);

    write_floats(part, &head, 1);
    write_floats(part, p->v[0], 6 * p->n);
}

long part_polygon_bytes(const struct part_polygon *p)
{
    return (1 + 6 * p->n) * (long)sizeof(float);
}

int part_read(FILE *part, struct part_polygon *p)
{
    float head;

    if (fread(&head, sizeof head, 1, part) != 1)
        return 0;
    p->node = (int)head / PART_NODE;
    p->n = (int)head % PART_NODE;
    if (p->n < 3 || p->n > POLYGON_MAX || (int)fread(p->v, sizeof *p->v, p->n, part) != p->n)
        fail("a part file is damaged");
    return 1;
}

int part_next(struct part_reader *r, struct part_polygon *p)
{
    char name[PART_NAME_SIZE];

    for (;;) {
        if (r->part && part_read(r->part, p))
            return 1;
        if (r->part) {
            fclose(r->part);
            r->node += r->step;
        }
        r->part = NULL;
        if (r->node >= r->nodes)
            return 0;
        part_name(name, r->prefix, r->surface, r->node);
        r->part = fopen(name, "rb");
        if (!r->part)
            fail("cannot read %s", name);
    }
}

void part_remove(const struct part_reader *r)
{
    char name[PART_NAME_SIZE];
    int node;

    for (node = 0; node < r->nodes; node += r->step) {
        part_name(name, r->prefix, r->surface, node);
        remove(name);
    }
}
