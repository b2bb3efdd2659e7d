/* page_surface.c - see page_surface.h. */
#include "lab/page/page_surface.h"
#include <string.h>
#include "kernel/xalloc.h"
#include "lab/page/data_columns.h"

static uint64_t bits(float f)
{
    uint32_t b;
    memcpy(&b, &f, sizeof b);
    return b;
}

static uint64_t place(const void *of, size_t i)
{
    const struct mesh *m = of;
    return bits(m->place[i / 3][i % 3]);
}

static uint64_t normal(const void *of, size_t i)
{
    const struct mesh *m = of;
    return bits(m->normal[i / 3][i % 3]);
}

static uint64_t corner(const void *of, size_t i)
{
    const struct mesh *m = of;
    return m->triangle[i / 3][i % 3];
}

static uint64_t node(const void *of, size_t i)
{
    const struct mesh *m = of;
    return m->node[m->of_face[i]];
}

void page_surface_write(const struct mesh *m, struct data_blob *b)
{
    struct column columns[4];
    size_t count = 0;
    columns[count++] = (struct column){"place", COLUMN_F32, (size_t)m->vertex_count * 3, place, m, NULL};
    columns[count++] = (struct column){"corner", COLUMN_I32, (size_t)m->triangle_count * 3, corner, m, ""};
    if (m->normal)
        columns[count++] =
            (struct column){"normal", COLUMN_F32, (size_t)m->vertex_count * 3, normal, m, NULL};
    if (m->node)
        columns[count++] = (struct column){"node", COLUMN_I32, m->triangle_count, node, m, ""};
    json_t *header = xchecked(
        json_pack("{s:I, s:I}", "faces", (json_int_t)m->face_count, "vertices", (json_int_t)m->vertex_count));
    data_columns_write(b, header, columns, count);
}
